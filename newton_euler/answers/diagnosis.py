"""Finds the mistake that explains a wrong answer. A mistake is reported only if it fits the answer,
differs clearly from the key, and is not contradicted by the parts that are right.
"""

import math
from functools import cached_property

from .fit import CLOSE, EXACT, LOOSE, Fit, is_apart
from .forms import WORDS
from .slips import (
    LISTED_RTOL,
    NUMBER_RTOL,
    ROUNDED,
    components,
    is_rounded,
    multiples,
    pairs,
    rates_as_scalars,
)

OR = "; or one that "  # between causes that give the same numbers
BOTH = ", and also "  # between two mistakes that were made together
OF_ALL_PARTS = ("listed", "unit", "book")  # groups of mistakes made once for the whole problem
MOST = 3  # causes that are told together: more would explain nothing
DIRECTION = "its size is right, its direction is not"
NEAR = "it is within 3 % of the right answer: keep more digits, and round at the end"
BOOK = "takes the numbers of the book instead of yours"


class Elsewhere:
    """What the other parts of a student's problem say about a cause.

    find : a function that returns [(is right, given, key, wrong models, rtol)] of each; called only
        where something fits
    """

    def __init__(self, find=list):
        self.find = find

    @cached_property
    def parts(self):
        return self.find()

    def contradicts(self, text):
        """True if a part is right in which this mistake would show. A term can be left out, and
        axes confused, in one part alone.
        """
        return any(
            right and any(is_apart(x, key) for g, t, x in wrong if t == text and g in OF_ALL_PARTS)
            for right, _, key, wrong, _ in self.parts
        )

    def explains(self, text):
        """In how many other wrong parts this mistake fits."""
        return sum(
            any(_fits(given, key, rtol, x) for _, other, x in wrong if other == text)
            for right, given, key, wrong, rtol in self.parts
            if not right
        )


def _fits(given, key, rtol, x):
    return x == given if _is_word(key) else Fit(given, key, rtol)(x)


def _is_word(key):
    return isinstance(key[0][0], str)


def causes(diagnosis):
    """The causes that a diagnosis names, as texts."""
    return diagnosis.split(OR) if diagnosis else []


def diagnose(given, key, wrong, rtol, kind="vector", factors=(), elsewhere=None):
    """What gives the wrong answer ``given``, as a sentence for the student, or None. Of causes that
    give the same numbers all are named.

    Answers are tuples of points; ``wrong`` lists the wrong models of this answer, [(group, text,
    points)], as :class:`~grader.scoring.numbers.Numbers` has them.

    factors : {text: factor} of the units that the answer may be in by mistake
    elsewhere : what the other parts of the problem say
    """
    elsewhere = elsewhere or Elsewhere()
    if kind in WORDS:  # of few words one is soon met by chance: listed mistakes only
        same = [text for group, text, x in wrong if group == "listed" and x == given]
        return _told([text for text in same if not elsewhere.contradicts(text)], elsewhere)
    fit = Fit(given, key, rtol)
    loose = []
    # what fits within the digits that were written goes before what fits within the tolerance
    for hits in _stages(fit, wrong, kind, factors or {}, elsewhere):
        best = max((level for level, _ in hits), default=0)
        if best >= CLOSE:
            return _told([text for level, text in hits if level == best], elsewhere)
        loose = loose or [text for _, text in hits]
    return _told(loose, elsewhere)


def _told(texts, elsewhere):
    """One cause, or several that fit alike; of these, the ones that explain most of the rest."""
    texts = list(dict.fromkeys(texts))
    if len(texts) > 1:
        counts = [elsewhere.explains(t) for t in texts]
        texts = [t for t, n in zip(texts, counts, strict=True) if n == max(counts)]
    return OR.join(texts) if 0 < len(texts) <= MOST else None


def _stages(fit, wrong, kind, factors, elsewhere):
    """[(closeness, text)] of the models that fit, from what is special to what is general."""
    near = fit.near(wrong)

    def of(candidates, rtol=None, apart=True):
        found = [(fit(x, rtol, apart), text) for text, x in candidates]
        return [hit for hit in found if hit[0] and not elsewhere.contradicts(hit[1])]

    def group(name):
        return [(text, x) for of_group, text, x in near if of_group == name]

    rounded = [(EXACT, ROUNDED)] if is_rounded(fit.given, fit.key) else []
    single, listed_alone = (NUMBER_RTOL, LISTED_RTOL) if kind == "number" else (None, None)
    yield [*of(group("listed"), listed_alone), *of(group("book"), single, apart=False), *rounded]
    yield of(group("term"))
    yield of(group("unit"), single)
    yield [
        *of(multiples(fit, factors), single),
        *_of_unlike_axes(group("axes"), fit),
        *_of_unlike_axes(group("turned"), fit),
    ]
    rates = [x for of_group, _, x in wrong if of_group == "rate"]
    yield of([*components(fit, kind), *rates_as_scalars(fit, rates)])
    listed = [(text, x) for of_group, text, x in wrong if of_group == "listed"]
    both = [pair for pair in pairs(fit, listed) if fit(pair[-1], NUMBER_RTOL)]
    possible = [p for p in both if not any(map(elsewhere.contradicts, p[:2]))]
    yield [(LOOSE, BOTH.join(p[:2])) for p in possible] if len(possible) == 1 else []


def _of_unlike_axes(models, fit):
    """Models that fit; of frames whose axes are parallel, the first."""
    seen, found = [fit.key], []
    for text, x in models:
        # a model that does not fit need not be compared with the others
        if level := fit(x):
            if not any(_same(x, other) for other in seen):
                found.append((level, text))
            seen.append(x)
    return found


def _same(a, b):
    return all(math.dist(x, y) <= 1e-9 * math.hypot(*x) for x, y in zip(a, b, strict=True))


def observe(given, key, kind):
    """What can be said of a wrong answer that no mistake explains, or None."""
    if kind.endswith("expression") or kind in WORDS:
        return None
    fit = Fit(given, key, 0.005)
    (given,), (key,), (size,) = given, key, fit.sizes
    if size and math.dist(given, key) <= 0.03 * size:
        return NEAR
    off = abs(math.hypot(*given) - size)
    return (
        DIRECTION if kind == "vector" and off <= max(1e-4 * size, fit.rounding) and size else None
    )
