"""Each student's own numbers: drawn within the ranges of a problem, rounded as in a textbook, and
rejected if they make a bad problem.
"""

import hashlib
import hmac
import inspect
import math
import random
from functools import cache

from newton_euler import compiled
from newton_euler.algebra.vectors import Vector

from .catalogue import CatalogueError, problem

DRAWS = 300  # attempts before a range is called impossible
# a mistake must differ from the key by this much of its size, or it could not be told from rounding
SEPARATION = 0.02
SENSITIVITY = 50  # a given rounded to 0.1 % may change an answer by 5 % at the most


def seed(secret, assignment, student, problem_id):
    """The seed of one student's numbers: HMAC-SHA256 of assignment, student and problem under the
    course's secret (bytes).
    """
    text = "\0".join((assignment, student, problem_id))
    return hmac.new(secret, text.encode(), hashlib.sha256).digest()


def draw(p, seed_bytes):
    """Values for every given of problem ``p``, in its units; the same for the same seed on every
    machine.
    """
    if not any(g.vary for g in p.givens.values()):
        return p.book_values
    for attempt in range(DRAWS):
        rng = random.Random(
            int.from_bytes(hashlib.sha256(seed_bytes + attempt.to_bytes(2, "big")).digest(), "big")
        )
        values = {n: _drawn(g, rng) for n, g in p.givens.items()}
        if not objection(p, values):
            return values
    raise CatalogueError(
        f"no good numbers for problem {p.id} in {DRAWS} draws: narrow its vary ranges; the "
        f"last draw {objection(p, values)}"
    )


def symbol_values(p, rng):
    """A random value for each symbol of a problem, within its ``vary``, to compare formulas at."""
    return {n: rng.uniform(*s.vary) for n, s in p.symbols.items()}


def _drawn(given, rng):
    if given.vary is None:
        return given.value
    low, high = given.vary
    step = _round_step((high - low) / 40)
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    value = rng.randint(first, last) * step
    digits = max(0, -math.floor(math.log10(step) + 1e-9))
    return round(value, digits)


def _round_step(x):
    """1, 2 or 5 times a power of ten, nearest below ``x``: the grid that drawn numbers lie on."""
    power = 10.0 ** math.floor(math.log10(x))
    return max(m for m in (1, 2, 5) if m * power <= x * (1 + 1e-9)) * power


def objection(p, values):
    """Why these values make a bad problem, or None: not finite, ill-conditioned, or a mistake that
    gives nearly the right answer.
    """
    right, wrong = evaluate(p, values)
    for key, answer in right.items():
        if not all(math.isfinite(x) for x in answer):
            return f"gives {key} = {answer}"
    for name, answers in wrong.items():
        for key, answer in answers.items():
            if distance(answer, right[key]) < SEPARATION:
                return f"hides the mistake {name}: its {key} is within {SEPARATION:.0%} of the key"
    for given, g in p.givens.items():
        if g.vary and values[given]:
            moved, _ = evaluate(p, {**values, given: values[given] * 1.001})
            for key in right:
                if distance(moved[key], right[key]) > 0.001 * SENSITIVITY:
                    return (
                        f"is ill-conditioned: 0.1 % of {given} changes {key} by "
                        f"{distance(moved[key], right[key]):.0%}"
                    )
    return None


def distance(a, b):
    """Difference of two answers (tuples of floats), relative to the size of ``b``; absolute where b
    is zero.
    """
    size = math.hypot(*b)
    return math.hypot(*(x - y for x, y in zip(a, b, strict=True))) / (size or 1.0)


def flat(answer):
    """An answer of any kind as a tuple of numbers: components, entries, bounds."""
    if isinstance(answer, (Vector, tuple, list)):
        return tuple(x for part in answer for x in flat(part))
    return (answer,)


def evaluate(p, values):
    """(key, mistakes) as tuples of floats: {answer: numbers}, {mistake: {answer: numbers}}; from
    the problem's formulas traced once.

    ``values`` may hold floats, or arrays of shape (N,) for a whole class at once.
    """
    run = _compiled(p.id)
    if run is None:
        return _evaluated(p, values)
    return run(**values)


def _evaluated(p, values):
    code, g = p.code, p.base(values)
    right = {k: flat(v) for k, v in p.in_units(code.solve(g)).items()}
    wrong = {
        name: {k: flat(v) for k, v in p.in_units(a).items()} for name, a in code.mistakes(g).items()
    }
    return right, wrong


@cache
def _compiled(problem_id):
    """The key and the mistakes of a problem as straight-line text; None for answers that are words
    or counts.
    """
    p = problem(problem_id)
    if not p.units or any(a.kind in ("choice", "count") for a in p.answers):
        return None

    def formula(**values):
        return _evaluated(p, values)

    formula.__signature__ = inspect.Signature(
        [inspect.Parameter(n, inspect.Parameter.POSITIONAL_OR_KEYWORD) for n in p.units]
    )
    return compiled(formula)


__all__ = ["distance", "draw", "evaluate", "flat", "objection", "seed", "symbol_values"]
