"""How often the grader recognises unlisted slips."""

import math
import random
from collections import Counter
from collections.abc import Iterable

import numpy as np

from exercises.catalogue import Problem
from exercises.catalogue.variants import draw
from newton_euler.answers.causes import GIVES_ZERO
from newton_euler.answers.fit import EXACT, Fit
from newton_euler.answers.slips import multiples, of_components, of_none, of_powers
from newton_euler.answers.tolerance import is_apart
from newton_euler.answers.verdicts import JudgedAnswer, explain

from ..scoring.numbers import numbers_of, points_of
from .slips_made import LISTED, made

SLIP_OUTCOMES = ("named", "followed", "silent", "misnamed")
DIGITS = (4, 6, 17)  # digits of an answer
RANDOM = "random numbers"
TRIES = 5  # random numbers for each answer


def slip_shares(problems: Iterable[Problem], draws: int) -> dict[str, Counter[str]]:
    """{kind of slip: Counter of :data:`SLIP_OUTCOMES`} over drawn numbers, for the wrong answers of
    :func:`.slips_made.made` and random numbers.

    named: with a cause that gives the same numbers; followed: as the sequel of a wrong answer;
    misnamed: with causes that do not give these numbers
    """
    found: dict[str, Counter[str]] = {}
    for p in problems:
        for n in range(draws if p.givens else 1):
            rng = random.Random(f"slips in {p.id} {n}")
            values = draw(p, rng.randbytes(8))
            with np.errstate(all="ignore"):  # roots of negative numbers are nan
                outcomes = [*_of_slips(p, values, rng), *_of_random(p, values, rng)]
            for kind, outcome in outcomes:
                found.setdefault(kind, Counter())[outcome] += 1
    return dict(sorted(found.items()))


def _of_slips(p, values, rng):
    numbers = numbers_of(p, values)
    for slip in made(p, values, rng):
        points = {k: points_of(p.answer(k), x) for k, x in slip.answers.items()}
        # floats: a zero may be the engine's own
        exact = {k: tuple(tuple(map(float, x)) for x in found) for k, found in points.items()}
        digits = rng.choice(DIGITS)
        whole = {k: _judged(p.answer(k), x, numbers) for k, x in exact.items()}
        judged = {k: _judged(p.answer(k), _written(x, digits), numbers) for k, x in exact.items()}
        for key in slip.wrong:
            finite = all(map(math.isfinite, exact[key][0]))
            if finite and judged[key].verdict == "wrong" and is_apart(exact[key], numbers.key[key]):
                yield slip.kind, _outcome(p.answer(key), judged, numbers, whole, slip)


def _of_random(p, values, rng):
    numbers = numbers_of(p, values)
    for a in p.answers:
        for _ in range(0 if a.kind.is_word or a.kind.is_formula else TRIES):
            right = numbers.key[a.key][0]
            scale = (math.hypot(*right) or 1.0) / math.sqrt(len(right))
            x = tuple(scale * rng.choice((-1, 1)) * 3 ** rng.uniform(-1, 1) for _ in right)
            judged = {a.key: _judged(a, _written((x,), rng.choice(DIGITS)), numbers)}
            if judged[a.key].verdict == "wrong":
                yield RANDOM, "named" if _causes(a, judged, numbers)[0] else "silent"


def _written(points, digits):
    if len(points) > 1:  # a formula keeps all digits
        return points
    return (tuple(float(f"{float(x):.{digits}g}") for x in points[0]),)


def _judged(asked, given, numbers):
    right = asked.kind.is_right(given, numbers.key[asked.key], asked.atol, asked.rtol)
    return JudgedAnswer("right" if right else "wrong", "", given)


def _outcome(asked, judged, numbers, whole, slip):
    causes, earlier = _causes(asked, judged, numbers)
    if earlier:
        return "followed"
    if not causes:
        return "silent"
    if slip.kind == LISTED:
        right = any((c.group, c.name) == ("listed", slip.name) for c in causes)
    else:
        right = _gives(causes, asked, numbers, whole)
    return "named" if right else "misnamed"


def _causes(asked, judged, numbers):
    why = explain(asked, judged, numbers)
    return [c for c in why.causes if not c.is_observation], why.earlier


def _gives(causes, asked, numbers, whole):
    """True if one of these causes gives exactly the numbers of an answer; ``whole`` has all their
    digits.
    """
    key, kind, exact = numbers.key[asked.key], asked.kind, whole[asked.key].given
    fit = Fit(exact, kind.like(key, exact), kind.rtol)
    if fit.index is None:  # nowhere have both a value
        return False
    models = [*numbers.wrong(asked.key), *kind.slips(fit), *of_none(fit, kind.is_vector)]
    models += multiples(fit, kind.factors(asked.unit), kind.is_along_axes)
    models += [*of_components(fit, kind.is_vector), *of_powers(fit, kind.is_vector)]
    models += [(c, x) for c in causes for x in numbers.slips.of(asked.key, c)]
    # also those in some components alone
    models += [(c, x) for _, c, x in numbers.slips.near(asked.key, fit, kind)]
    models += [(c, numbers.book[asked.key]) for c in causes if c.group == "book"]
    models += [(c, numbers.key[c.name]) for c in causes if c.group == "exchanged"]
    gives = any(fit(kind.like(x, exact)) == EXACT for cause, x in models if cause in causes)
    is_zero = GIVES_ZERO in causes and not any(map(any, exact))
    return gives or is_zero or any(c in causes for c in _again(asked, numbers, whole))


def _again(asked, numbers, whole):
    """The causes that are found with all digits written, too: slips in later steps, and two
    mistakes together, which almost never fit by chance.
    """
    found, _ = _causes(asked, whole, numbers)
    groups = "sequel", "both", "usual", "powers"
    return [c for c in found if c.group in groups or c == GIVES_ZERO]
