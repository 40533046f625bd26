"""Finds the mistake that explains a wrong answer. A mistake is reported only if it fits the answer,
differs clearly from the key, and is named "in this part" where the parts that are right contradict
it.
"""

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import chain
from typing import NamedTuple

from . import causes
from .by_component import of_each_component
from .causes import CORIOLIS_HALVED, LEFT_OUT, RESCALED, ZERO, Cause, in_this_part
from .fit import CLOSE, EXACT, LOOSE, Fit
from .kinds import KINDS, Kind
from .near import NO_SINGLES, Singles
from .pairs import of_two
from .slips import bare, is_rounded, multiples, of_components, of_none, of_powers, rates_as_scalars
from .tolerance import NOISE, NUMBER_RTOL, Points, is_apart

MOST = 3  # causes that are named together: more would explain nothing

Model = tuple[Cause, Points]  # the answer by a wrong model
Near = tuple[int, Cause, Points]  # the answer with a slip, and how simple that is: 1 is simplest


class OtherPart(NamedTuple):
    """Another part of the problem that the student answered, and its wrong models."""

    right: bool
    kind: Kind
    given: Points
    key: Points
    wrong: Sequence[Model]
    slips: Callable[[Cause], Sequence[Points]] = lambda cause: ()
    name: str = ""

    def models(self, cause: Cause) -> Iterator[Points]:
        """The answers to this part that a cause would give."""
        yield from (x for c, x in self.wrong if c == cause)
        yield from (self.kind.like(x, self.given) for x in self.slips(cause))

    def fits(self, x: Points) -> bool:
        """True if a model explains the answer to this part."""
        of_word = self.kind.is_word
        return x == self.given if of_word else bool(Fit(self.given, self.key, self.kind.rtol)(x))


class OtherParts:
    """The other parts of a student's problem, as evidence for or against a cause.

    find : a function that returns each part as :class:`OtherPart`; called only when a cause fits
    """

    def __init__(self, find: Callable[[], Iterable[OtherPart]] = tuple):
        self._find = find

    @cached_property
    def _parts(self):
        return list(self._find())

    def contradicts(self, cause: Cause) -> bool:
        """True if a part is right in which this mistake would show."""
        return cause.shows_everywhere and any(
            part.right and any(is_apart(x, part.key) for x in part.models(cause))
            for part in self._parts
        )

    def refutes(self, cause: Cause) -> bool:
        """True if this listed mistake would show in other parts, and explains none of them, or if
        a slip takes something else for another answer, which is right.
        """
        if cause.answers:
            return {part.name for part in self._parts if part.right}.issuperset(cause.answers)
        shown = cause.group == "listed" and any(
            is_apart(x, part.key) for part in self._parts for x in part.models(cause)
        )
        return shown and not self.explains(cause)

    def has_more(self, found: Iterable[Cause]) -> bool:
        """True if other parts are wrong that these mistakes would show in, but do not explain."""
        wrong = sum(not part.right for part in self._parts)
        return wrong > 0 and all(c.shows_everywhere and self.explains(c) < wrong for c in found)

    def explains(self, cause: Cause) -> int:
        """The number of other wrong parts that this mistake explains."""
        wrong = (part for part in self._parts if not part.right)
        return sum(any(map(part.fits, part.models(cause))) for part in wrong)


def diagnose(
    given: Points,
    key: Points,
    wrong: Sequence[Model],
    kind: Kind = KINDS["vector"],
    factors: Mapping[str, float] | None = None,
    elsewhere: OtherParts | None = None,
    slips: Callable[[Fit, Kind], Sequence[Near]] | None = None,
    singles: Callable[[], Singles] = lambda: NO_SINGLES,
) -> tuple[Cause, ...]:
    """The causes of the wrong answer ``given``: all that give the same numbers; () if nothing
    explains it.

    wrong : the wrong models of this answer
    factors : {words: factor} of the units that the answer may be in by mistake
    elsewhere : the other parts of the problem
    slips : finds the slips in the computation that the answer is near to; None for an answer that
        follows from earlier ones, where nothing more general is tried
    singles : finds the slips that may be made beside another mistake
    """
    elsewhere = elsewhere or OtherParts()
    if kind.is_word:  # one of few words is soon met by chance: only mistakes listed, and of counts
        models = [m for m in wrong if m[1] == given and m[0].group in ("listed", "count")]
        hits = [Hit(EXACT, *m) for m in models if not elsewhere.refutes(m[0])]
        # after the first listed mistake come those that any count may have
        hits[1:] = sorted(hits[1:], key=lambda hit: hit.cause.group == "listed")
        return _best([hits[:MOST]], elsewhere, ())
    fit = Fit(given, key, kind.rtol)
    if fit.index is None:  # nowhere have both a value
        return ()
    single = [*_stages(fit, wrong, kind, factors or {})]
    general = _closest(single)
    # a factor of some components, within the digits written: one slip goes before two
    least = LOOSE if kind.is_formula else CLOSE
    doubtful = (_says_little(h.cause, kind) or elsewhere.contradicts(h.cause) for h in general)
    is_doubtful = all(doubtful)  # or else listed mistakes cost less to try
    computed: list[Hit] = []
    by_factor = _first(of_components(fit, kind.is_vector), fit, least)  # in plain words
    if slips and (is_doubtful or elsewhere.has_more(h.cause for h in general)):
        computed = _simplest(fit, slips(fit, kind), elsewhere)
        if general:  # which says in words of the problem what a slip says of earlier components
            computed = [h for h in computed if h.cause.group != "sequel"]
        if any(elsewhere.contradicts(h.cause) for h in general):
            computed = [h for h in computed if not elsewhere.contradicts(h.cause)]
        least_general = min((h.level for h in general), default=EXACT)
        if is_doubtful and max((h.level for h in computed), default=0) > least_general:
            single, general = [], []  # a mere factor, in fewer digits
        if general or by_factor:
            computed = [h for h in computed if not _is_bare(h, fit) or elsewhere.explains(h.cause)]
        if not is_doubtful:  # one mistake behind more wrong parts is likelier than several
            most = max(elsewhere.explains(h.cause) for h in general)
            computed = [h for h in computed if elsewhere.explains(h.cause) > most]
    if general:  # either may have been done: they give the same numbers
        both_kinds = *_best(single, elsewhere, fit.sizes), *_best([computed], elsewhere, fit.sizes)
        found = _most_explaining(both_kinds, elsewhere)[:MOST]
        is_listed = any(c.group == "listed" for c in found)
        of_number = lambda c: is_listed and _is_of_a_number(c)  # noqa: E731
        found = tuple(sorted(found, key=lambda c: (of_number(c), elsewhere.contradicts(c))))
    else:
        found = _best([*single, computed], elsewhere, fit.sizes)
    # many of them give a mere factor, but not in other parts as well
    if found and all(c.group == "computed" and not elsewhere.explains(c) for c in found):
        found = *_first(bare(fit), fit, CLOSE), *found
    found = found or by_factor
    found = found or (_first(of_powers(fit, kind.is_vector), fit, least) if slips else ())
    terms = [m for m in wrong if m[0].group in ("listed", "omitted", "term", "unit")]
    if not found and not any(map(any, given)) and any(map(any, key)):
        return (causes.GIVES_ZERO,)
    found = found or of_two(fit, kind, terms, singles, elsewhere.contradicts)
    found = found or (of_each_component(fit, kind, wrong, slips) if slips else ())
    return found or tuple(cause for cause, x in of_none(fit, kind.is_vector) if fit(x))


def _says_little(cause, kind):
    """True of a cause that a slip may explain better: a factor, a zero, a formula of the book."""
    of_book = cause.group == "book" and kind.is_formula
    return of_book or cause.group in ("factor", "usual") or cause.does == causes.NO_COMPONENT


def _is_of_a_number(cause):
    """True of a cause that names another number, not what is left out or reversed."""
    return cause.group in ("factor", "usual") or (cause.group == "computed" and not cause.does)


def _is_bare(hit, fit):
    """True of twice or half a quantity, where this is a factor of 2 of the whole or of a component:
    any quantity in it would do. In two of three components it is evidence.
    """
    ratios: dict[int, set[float]] = {}
    for x, key in zip(hit.points, fit.key, strict=True):
        for n, (a, k) in enumerate(zip(x, key, strict=True)):
            if k and math.isfinite(a / k):
                ratios.setdefault(n, set()).add(round(a / k, 9))
    changed = [r for r in ratios.values() if r != {1.0}]
    is_whole_or_one = len(changed) in (1, len(ratios)) and changed[1:] == changed[:-1]
    return hit.cause.does == causes.FACTOR_2 and is_whole_or_one and changed[0] in ({2.0}, {0.5})


class Hit(NamedTuple):
    """A model that fits, and how closely."""

    level: int
    cause: Cause
    points: Points


def _best(stages, elsewhere, sizes):
    """The causes of the stage that fits best, then those of all others with the same numbers.

    A fit within the digits that were written goes before one within the tolerance; a cause that the
    right parts contradict must fit within the digits: it was made in this part only.
    """
    if not (stages := [*filter(None, stages)]):
        return ()
    contradicted = {h.cause for hits in stages for h in hits if elsewhere.contradicts(h.cause)}
    possible = [[h for h in hits if h.cause not in contradicted] for hits in stages]
    rest = ([h for h in hits if h.cause in contradicted] for hits in stages)
    here = [[h._replace(cause=in_this_part(h.cause)) for h in hits] for hits in rest]
    # numbers in a formula, written in five digits, are never as close
    formulas = ([h for h in hits if len(h.points) > 1] for hits in here)
    best = _closest(possible) or _closest(here) or next(filter(None, [*possible, *formulas]), [])
    named = {h.cause.name for h in best if h.cause.group == "listed"}
    twins = [
        h
        for h in chain(*possible, *here)
        if h.cause.adds_to_others
        if not (h.cause.does == RESCALED and h.cause.subject in named)  # it says the same
        if any(_same(h.points, o.points, sizes) for o in best)
    ]
    return _chosen([h.cause for h in best], [h.cause for h in twins], elsewhere)


def _simplest(fit, near, elsewhere):
    """The simplest of the slips in a computation that fit best, each in different words: first
    those that explain most other parts; a slip that is made in one part alone is less simple.
    """
    near = [slip for slip in near if not elsewhere.refutes(slip[1])]
    hits = [(level, Hit(_level(fit, x), cause, x)) for level, cause, x in near]
    if any(hit.cause.group == "unit" for _, hit in hits):
        # a number in a wrong unit may be nearly zero, or nearly the whole
        hits = [(1 if hit.cause.does in (LEFT_OUT, ZERO) else n, hit) for n, hit in hits]
        left = [hit for n, hit in hits if hit.level and hit.cause.does in (LEFT_OUT, ZERO)]
        if left and len(fit.key) > 1:  # numbers in a formula do not tell these apart
            hits = [(n, hit) for n, hit in hits if hit.cause.group != "unit"]
    best = max((hit.level for _, hit in hits), default=0)
    fitting = [(n, hit) for n, hit in hits if hit.level and hit.level >= min(best, CLOSE)]
    if elsewhere.has_more(()):
        counts = [elsewhere.explains(hit.cause) for _, hit in fitting]
        fitting = [x for x, n in zip(fitting, counts, strict=True) if n == max(counts)]
    found = [(n + elsewhere.contradicts(hit.cause), hit) for n, hit in fitting]
    simplest = min((n for n, _ in found), default=0)
    words: dict[str, Hit] = {}
    for n, hit in found:
        if n == simplest:
            words[hit.cause.subject or hit.cause.what] = words.get(hit.cause.what, hit)
    return [*words.values()][:MOST]


def _level(fit, x):
    """How well a slip fits; one that is met in the digits written may be near the key."""
    level = fit(x, apart=len(fit.key[0]) > 1)
    return level if level >= CLOSE else fit(x)


def _closest(stages):
    """The closest of the first stage in which something fits within the digits written."""
    for hits in stages:
        best = max((h.level for h in hits), default=0)
        if best >= CLOSE:
            return [h for h in hits if h.level == best]
    return []


def _chosen(best, twins, elsewhere):
    """The causes that explain most of the other parts, the listed ones first."""
    found = _most_explaining(dict.fromkeys([*best, *twins]), elsewhere)
    kept = sorted(found, key=lambda c: c.group != "listed")[:MOST]
    few = sum(c in best for c in found) <= MOST
    return tuple(c for c in found if c in kept) if few else ()


def _most_explaining(found, elsewhere):
    """Those causes that explain the most other wrong parts; a mere factor always stays, and so does
    the factor 2 of the Coriolis term, which shows in vectors only.
    """
    if len(found) < 2:
        return tuple(found)
    counts = {c: elsewhere.explains(c) for c in found}
    most = {c for c in found if counts[c] == max(counts.values())}
    return tuple(c for c in found if c in most or c == CORIOLIS_HALVED or c.group == "factor")


def _stages(
    fit: Fit, wrong: Sequence[Model], kind: Kind, factors: Mapping[str, float]
) -> Iterator[list[Hit]]:
    """The models that fit, from the special to the general."""
    near = defaultdict[str, list[Model]](list)
    for model in fit.near(wrong):
        near[model[0].group].append(model)

    def of(candidates, rtol=None, apart=True):
        hits = [Hit(fit(x, rtol, apart), cause, x) for cause, x in candidates]
        return [hit for hit in hits if hit.level]

    # a single number, read as 2.5, may have lost a zero that was written in 2.50
    surely_rounded = is_rounded(fit.given, fit.key) and sum(map(bool, fit.given[0])) > 1
    rounded = [Hit(EXACT, causes.ROUNDED, fit.given)] if surely_rounded else []
    single = NUMBER_RTOL if kind.is_met_by_chance else None
    yield [*of(near["listed"], single), *of(near["book"], single, apart=False), *rounded]
    yield of([*near["omitted"], *near["term"]], single)
    yield of(near["unit"], single)
    yield [
        *of(multiples(fit, factors, kind.is_along_axes), single),
        *of(m for m in wrong if m[0].group == "usual"),
        *_of_unlike_axes(near["axes"], fit),
        *_of_unlike_axes(near["turned"], fit),
    ]
    rates = [x for cause, x in wrong if cause.group == "rate"]
    yield of([*kind.slips(fit), *rates_as_scalars(fit, rates)])
    yield of(near["exchanged"], single)


def _first(models, fit, least):
    """The first cause that fits at least at this level."""
    return tuple(cause for cause, x in models if fit(x) >= least)[:1]


def _of_unlike_axes(models, fit):
    """Models that fit; of frames whose axes are parallel, the first."""
    seen, found = [fit.key], []
    for cause, x in models:
        # a model that does not fit need not be compared with the others
        if level := fit(x):
            if not any(_same(x, other, fit.sizes) for other in seen):
                found.append(Hit(level, cause, x))
            seen.append(x)
    return found


def _same(a, b, sizes):
    triples = zip(a, b, sizes, strict=True)
    return a == b or all(math.dist(x, y) <= NOISE * size for x, y, size in triples)
