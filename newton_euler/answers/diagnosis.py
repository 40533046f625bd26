"""Finds the mistake that explains a wrong answer. A mistake is reported only if it fits the answer,
differs clearly from the key, and is not contradicted by the parts that are right.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from .causes import ROUNDED, Cause, both
from .fit import CLOSE, EXACT, LOOSE, Fit
from .kinds import KINDS, Kind
from .slips import is_rounded, multiples, pairs, rates_as_scalars
from .tolerance import LISTED_RTOL, NOISE, NUMBER_RTOL, Points, is_apart

MOST = 3  # causes that are named together: more would explain nothing

Model = tuple[Cause, Points]  # what a wrong model makes of an answer


class Answered(NamedTuple):
    """Another part of the problem that the student answered, and its wrong models."""

    right: bool
    kind: Kind
    given: Points
    key: Points
    wrong: Sequence[Model]


class Elsewhere:
    """What the other parts of a student's problem say about a cause.

    find : a function that returns each part as :class:`Answered`; called only where something fits
    """

    def __init__(self, find: Callable[[], Iterable[Answered]] = tuple):
        self._find = find

    @cached_property
    def _parts(self):
        return list(self._find())

    def contradicts(self, cause: Cause) -> bool:
        """True if a part is right in which this mistake would show."""
        return cause.shows_everywhere and any(
            part.right and any(c == cause and is_apart(x, part.key) for c, x in part.wrong)
            for part in self._parts
        )

    def explains(self, cause: Cause) -> int:
        """In how many other wrong parts this mistake fits."""
        return sum(
            any(c == cause and _fits(part, x) for c, x in part.wrong)
            for part in self._parts
            if not part.right
        )


def _fits(part, x):
    if part.kind.is_word:
        return x == part.given
    return Fit(part.given, part.key, part.kind.rtol)(x)


def diagnose(
    given: Points,
    key: Points,
    wrong: Sequence[Model],
    kind: Kind = KINDS["vector"],
    factors: Mapping[str, float] | None = None,
    elsewhere: Elsewhere | None = None,
) -> tuple[Cause, ...]:
    """What gives the wrong answer ``given``: all causes that give the same numbers; none if nothing
    explains it.

    wrong : the wrong models of this answer
    factors : {words: factor} of the units that the answer may be in by mistake
    elsewhere : what the other parts of the problem say
    """
    elsewhere = elsewhere or Elsewhere()
    if kind.is_word:  # of few words one is soon met by chance: listed mistakes only
        same = [cause for cause, x in wrong if cause.group == "listed" and x == given]
        return _chosen([c for c in same if not elsewhere.contradicts(c)], elsewhere)
    fit = Fit(given, key, kind.rtol)
    loose: list[Cause] = []
    # what fits within the digits that were written goes before what fits within the tolerance
    for hits in _stages(fit, wrong, kind, factors or {}, elsewhere):
        best = max((level for level, _ in hits), default=0)
        if best >= CLOSE:
            return _chosen([cause for level, cause in hits if level == best], elsewhere)
        loose = loose or [cause for _, cause in hits]
    return _chosen(loose, elsewhere)


def _chosen(causes, elsewhere):
    """One cause, or several that fit alike; of these, the ones that explain most of the rest."""
    causes = list(dict.fromkeys(causes))
    if len(causes) > 1:
        counts = [elsewhere.explains(c) for c in causes]
        causes = [c for c, n in zip(causes, counts, strict=True) if n == max(counts)]
    return tuple(causes) if len(causes) <= MOST else ()


def _stages(
    fit: Fit,
    wrong: Sequence[Model],
    kind: Kind,
    factors: Mapping[str, float],
    elsewhere: Elsewhere,
) -> Iterator[list[tuple[int, Cause]]]:
    """[(closeness, cause)] of the models that fit, from what is special to what is general."""
    near = fit.near(wrong)

    def of(candidates, rtol=None, apart=True):
        found = [(fit(x, rtol, apart), cause) for cause, x in candidates]
        return [hit for hit in found if hit[0] and not elsewhere.contradicts(hit[1])]

    def group(name, models=near):
        return [model for model in models if model[0].group == name]

    rounded = [(EXACT, ROUNDED)] if _is_surely_rounded(fit) else []
    single, listed_alone = (NUMBER_RTOL, LISTED_RTOL) if kind.is_met_by_chance else (None, None)
    yield [*of(group("listed"), listed_alone), *of(group("book"), single, apart=False), *rounded]
    yield of(group("term"))
    yield of(group("unit"), single)
    yield [
        *of(multiples(fit, factors), single),
        *_of_unlike_axes(group("axes"), fit),
        *_of_unlike_axes(group("turned"), fit),
    ]
    rates = [x for _, x in group("rate", wrong)]
    yield of([*kind.slips(fit), *rates_as_scalars(fit, rates)])
    found = [pair for pair in pairs(fit, group("listed", wrong)) if fit(pair[-1], NUMBER_RTOL)]
    possible = [p[:2] for p in found if not any(map(elsewhere.contradicts, p[:2]))]
    yield [(LOOSE, both(*pair)) for pair in possible] if len(possible) == 1 else []


def _is_surely_rounded(fit):
    """True of several components in few digits; in a single one, read as 2.5, a zero may be lost
    that was written in 2.50.
    """
    return is_rounded(fit.given, fit.key) and sum(map(bool, fit.given[0])) > 1


def _of_unlike_axes(models, fit):
    """Models that fit; of frames whose axes are parallel, the first."""
    seen, found = [fit.key], []
    for cause, x in models:
        # a model that does not fit need not be compared with the others
        if level := fit(x):
            if not any(_same(x, other) for other in seen):
                found.append((level, cause))
            seen.append(x)
    return found


def _same(a, b):
    return all(math.dist(x, y) <= NOISE * math.hypot(*x) for x, y in zip(a, b, strict=True))
