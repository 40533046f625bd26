"""Each student's numbers: drawn within ranges, round, rejected if they make a bad problem."""

import hashlib
import hmac
import inspect
import math
import random
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from typing import Any, TypeAlias

from newton_euler import compiled
from newton_euler.algebra.late import np
from newton_euler.algebra.scalars import Scalar
from newton_euler.algebra.vectors import Vector
from newton_euler.answers.tolerance import MAJORITY, SEPARATION, distance

from .model import CatalogueError, Given, Problem

Points: TypeAlias = tuple[tuple, ...]  # the components of an answer at each point
Answers: TypeAlias = dict[str, Points]
DRAWS = 300  # attempts before giving up
POINTS = 8  # number of points at which formulas are compared
SENSITIVITY = 50  # rounding a given to 0.1 % may change an answer by 5 % at most


def seed(secret: bytes, assignment: str, student: str, problem_id: str) -> bytes:
    """The seed of one student's numbers: HMAC-SHA256 of the rest, keyed by the course's secret."""
    text = "\0".join((assignment, student, problem_id))
    return hmac.new(secret, text.encode(), hashlib.sha256).digest()


def practice_seed(p: Problem, n: int, what: str = "practice") -> bytes:
    """The seed of the numbers of practice variant ``n``."""
    return f"{what} {p.id} {n}".encode()


def draw(p: Problem, seed_bytes: bytes) -> dict[str, float]:
    """Values for every given of ``p``, in its units; the same for a seed on every machine."""
    if not any(g.vary for g in p.givens.values()):
        return p.book_values
    for attempt in range(DRAWS):
        digest = hashlib.sha256(seed_bytes + attempt.to_bytes(2, "big")).digest()
        rng = random.Random(int.from_bytes(digest, "big"))
        values = {n: drawn_value(g, rng) for n, g in p.givens.items()}
        if not objection(p, values):
            return values
    raise CatalogueError(
        f"no good numbers for problem {p.id} in {DRAWS} draws: narrow its vary ranges; the "
        f"last draw {objection(p, values)}"
    )


def symbol_values(p: Problem, rng: random.Random) -> dict[str, float]:
    """A random value within ``vary`` for each symbol of a problem."""
    return {n: rng.uniform(*s.vary) for n, s in p.symbols.items()}


@cache
def symbol_points(p: Problem) -> dict[str, Any]:
    """{symbol: array}, the points at which formulas are compared, the same for all students."""
    rng = random.Random(f"points of {p.id}")
    points = [symbol_values(p, rng) for _ in range(POINTS)]
    return {n: np.array([x[n] for x in points]) for n in p.symbols}


def drawn_value(given: Given, rng: random.Random) -> float:
    """A random round number within the range of a given."""
    if given.vary is None:
        return given.value
    first, last, step = _grid(given.vary)
    value = rng.randint(first, last) * step
    return round(value, max(0, -math.floor(math.log10(step))))


def sheets(p: Problem) -> int:
    """The number of variants, those that :func:`objection` refuses too; 1 if nothing varies."""
    grids = [_grid(g.vary) for g in p.givens.values() if g.vary]
    return math.prod(last - first + 1 for first, last, _ in grids)


def _grid(span):
    """(first, last, step): the round numbers within a range are n * step, n from first to last."""
    low, high = span
    step = _round_step((high - low) / 40)
    return math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9), step


def _round_step(x):
    """The largest 1, 2 or 5 times a power of ten up to ``x``."""
    power = 10.0 ** math.floor(math.log10(x))
    return max(m for m in (1, 2, 5) if m * power <= x * (1 + 1e-9)) * power


class Hides(str):
    """An objection to numbers for which a mistake gives nearly the right answer."""


def objection(p: Problem, values: Mapping[str, Scalar]) -> str | None:
    """Why these values make a bad problem, or None: not finite, ill-conditioned, a negligible
    component, or a mistake that gives nearly the right answer. Judged over the points that scoring
    uses. A mistake that has no real answer with these numbers cannot be made with them, and one in
    a word may give the right one.
    """
    right, wrong = at_points(p, values)
    for key, points in right.items():
        if fault := p.answer(key).kind.unfit(points):
            return f"gives {key} {fault}"
    for name, answers in wrong.items():
        for key, points in answers.items():
            kind = p.answer(key).kind
            if not kind.is_word and not apart(kind.like(points, right[key]), right[key]):
                near = f"its {key} is within {SEPARATION:.0%} of the key"
                return Hides(f"hides the mistake {name}: {near}")
    return _ill_conditioned(p, values, right)


def _ill_conditioned(p, values, right):
    """The given that changes an answer by far more than itself, in words, or None."""
    for given, g in p.givens.items():
        if not (g.vary and values[given]):
            continue
        moved, _ = at_points(p, {**values, given: values[given] * 1.001})
        for key, points in right.items():
            change = p.answer(key).kind.change(moved[key], points)
            if not change <= 0.001 * SENSITIVITY:
                by = "" if math.isinf(change) else f" by {change:.0%}"
                return f"is ill-conditioned: 0.1 % of {given} changes {key}{by}"
    return None


def apart(wrong: Points, right: Points) -> bool:
    """True if a wrong answer is far from the key at half or more of the points where both are real,
    or if there are no such points. Answers are tuples of points.
    """
    pairs = zip(wrong, right, strict=True)
    real = [(x, key) for x, key in pairs if math.isfinite(math.hypot(*x, *key))]
    far = [distance(x, key) >= SEPARATION for x, key in real]
    return sum(far) >= MAJORITY * len(far)


def flat(answer: Any) -> tuple[Any, ...]:
    """An answer of any kind as a tuple of numbers: components, entries, bounds."""
    if isinstance(answer, (Vector, tuple, list)):
        return tuple(x for part in answer for x in flat(part))
    return (answer,)


def at_points(p: Problem, values: Mapping[str, Scalar]) -> tuple[Answers, dict[str, Answers]]:
    """(key, mistakes) as tuples of points: {answer: points}, {mistake: {answer: points}}.

    A point is a tuple of components, floats or words; nan where a formula is not real. A formula
    has a point for each of :func:`symbol_points`, unless ``values`` includes the symbols.
    """
    values = {**symbol_points(p), **values}
    try:
        right, wrong = evaluate(p, values)
    except (ArithmeticError, ValueError):  # arrays have nan where floats raise
        with np.errstate(all="ignore"):
            right, wrong = evaluate(p, {n: np.atleast_1d(float(x)) if np.ndim(x) == 0 else x
                                        for n, x in values.items()})  # fmt: skip
    count = max((len(x) for x in values.values() if np.ndim(x)), default=1)
    return (
        {k: as_points(x, count) for k, x in right.items()},
        {n: {k: as_points(x, count) for k, x in a.items()} for n, a in wrong.items()},
    )


_SCALARS = {float, int, str}


def as_points(components: Sequence[Any], count: int = 1) -> Points:
    """An answer's components (floats, words, arrays) as ``count`` points, or those of arrays."""
    if count == 1 and _SCALARS.issuperset(map(type, components)):
        return (tuple(components),)
    arrays = [np.asarray(x) for x in components]
    rows = [(r if r.dtype.kind in "OU" else r.astype(float)).ravel().tolist() for r in arrays]
    count = max(count, *map(len, rows))  # np.broadcast_arrays takes three times as long
    return tuple(zip(*(row * count if len(row) == 1 else row for row in rows), strict=True))


def evaluate(p: Problem, values: Mapping[str, Scalar]) -> tuple[dict, dict]:
    """(key, mistakes) as tuples of floats: {answer: numbers}, {mistake: {answer: numbers}}, by
    formulas traced once.

    ``values`` may hold floats, or arrays of shape (N,) for a whole class at once.
    """
    run = _compiled(p)
    with np.errstate(all="ignore"):
        return _evaluated(p, values) if run is None else run(**values)


def _evaluated(p, values):
    right = {k: flat(v) for k, v in p.solve(values).items()}
    wrong = {name: {k: flat(v) for k, v in a.items()} for name, a in p.wrong(values).items()}
    return right, wrong


@cache
def _compiled(p):
    """The key and the mistakes as straight-line code; None if there are words or counts."""
    return traced(p, _evaluated)


def traced(
    p: Problem, formula: Callable[..., Any], more: Iterable[str] = ()
) -> Callable[..., Any] | None:
    """``formula(p, values)`` as straight-line code, called with the values by name; None if problem
    ``p`` has no numbers, or answers that are words or counts. ``more`` names further values.
    """
    if not p.units or p.has_words:
        return None

    def run(**values):
        return formula(p, values)

    names = (*p.units, *more)
    run.__signature__ = inspect.Signature(  # type: ignore[attr-defined]
        [inspect.Parameter(n, inspect.Parameter.POSITIONAL_OR_KEYWORD) for n in names]
    )
    return compiled(run)
