"""How well the numbers of a wrong model fit a wrong answer: closely, loosely or not at all."""

import math
from collections.abc import Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any

from .tolerance import DIGITS, NOISE, ROUND_OFF, Point, Points, is_apart

LOOSE, CLOSE, EXACT = 1, 2, 3
LEAST = 1e-3  # fraction of the whole by which any component may be off
SIMPLE = 12  # the largest denominator of a simple number
EFFECT = 0.05  # fraction of a mistake's effect: a model that fits is nearer than this


class Fit:
    """Compares models with a wrong answer ``given``, a tuple of points. A model fits if it is near
    the answer at every point, and away from the key.
    """

    def __init__(self, given: Points, key: Points, rtol: float):
        self.given, self.key, self.rtol = given, key, rtol
        self.sizes = [math.hypot(*k) for k in key]
        own = (k + math.hypot(*x) for k, x in zip(self.sizes, given, strict=False))
        # the first point; without one (None) nothing is explained
        self.index: Any = next((n for n, size in enumerate(own) if math.isfinite(size)), None)

    def near(self, models: Iterable[tuple[Any, Points]]) -> list[tuple[Any, Points]]:
        """Those of [(cause, points)] that may fit, by one component, which rules nearly all out."""
        given, _, size = self.first
        reach = 1.02 * self.rtol * math.hypot(*given) + NOISE * size
        n, x = self.index, given[0]
        return [(cause, points) for cause, points in models if not abs(points[n][0] - x) > reach]

    @cached_property
    def rounding(self) -> float:
        """How far the student's rounding may have moved the answer; a formula has all its digits. A
        right component of few digits, such as 3.3, counts by its actual distance.
        """
        if len(self.key) > 1:
            return 0.0
        (given,), (key,) = self.given, self.key
        size, own = math.hypot(*given), [rounding([x]) for x in given]
        if len(given) > 1:
            own = [min(r, abs(x - k)) for r, x, k in zip(own, given, key, strict=True)]
        return min(math.hypot(*own), self.rtol * size)

    @cached_property
    def nearest(self) -> float:
        """As :meth:`rounding`; a single number counts as written in three digits at least: as a
        float, 2.50 has lost its zero.
        """
        x, *others = self.given[0]
        asked = 0.5 * 10.0 ** (math.floor(math.log10(abs(x))) + 1 - DIGITS) if x else 0.0
        return self.rounding if others else min(self.rounding, asked)

    @cached_property
    def is_plain(self) -> bool:
        """True of a formula that is one simple number, or a simple part of pi, at all points: what
        is computed without the quantity that matters is as plain, and so is any guess.
        """
        if len(self.given) == 1 or len(self.given[0]) > 1 or len(set(self.given)) > 1:
            return False
        parts = (self.given[0][0] / one for one in (1, math.pi))
        return any(
            math.isfinite(x) and abs(x - Fraction(x).limit_denominator(SIMPLE)) <= ROUND_OFF
            for x in parts
        )

    def off(self, near: float = NOISE) -> list[int]:
        """The places of components that are off by more than ``near``, relative to the whole."""
        triples = [*zip(self.given, self.key, self.sizes, strict=True)]
        places = range(len(self.key[0]))
        return [n for n in places if any(abs(x[n] - k[n]) > near * s for x, k, s in triples)]

    def times(self, factor: float) -> Points:
        """The key times a factor."""
        return scaled_points(factor, self.key)

    @property
    def first(self) -> tuple[Point, Point, float]:
        """(answer, key, size of the key) at the first point where the key has a value."""
        return self.given[self.index], self.key[self.index], self.sizes[self.index]

    def __call__(self, numbers: Points, rtol: float | None = None, apart: bool = True) -> int:
        """``EXACT`` if the model differs by round-off only, ``CLOSE`` if by the student's rounding,
        ``LOOSE`` if by less than ``rtol`` of its size, 0 if it does not fit.
        """
        level = self._near(numbers, self.rtol if rtol is None else rtol)
        return level if level and (not apart or is_apart(numbers, self.key)) else 0

    def _near(self, numbers, rtol):
        level = 0  # while no point has a value
        for x, given, key, size in zip(numbers, self.given, self.key, self.sizes, strict=True):
            own = math.hypot(*x)
            if not (math.isfinite(own) and math.isfinite(size)):
                continue
            gap = math.dist(x, given)
            if not gap <= max(self.rtol * own, NOISE * size):
                return 0
            if gap > max(self.rounding, EFFECT * math.dist(given, key)):
                return 0
            if not (here := self._closeness(gap, own, size, rtol)):
                return 0
            # a component is near by its own size, and a small one has the right sign
            noise, least = NOISE * (own + size), LEAST * own
            if any(
                abs(a - b) > min(abs(a) / 2, self.rtol * abs(a) + least) + noise
                for a, b in zip(x, given, strict=True)
            ):
                return 0
            level = min(level or here, here)
        return level

    def _closeness(self, gap, own, size, rtol):
        if gap <= max(ROUND_OFF * own, NOISE * size):
            return EXACT
        return CLOSE if gap <= self.nearest else LOOSE if gap <= rtol * own else 0


def scaled_points(factor: float, points: Points) -> Points:
    """The points times a factor."""
    return tuple(tuple(factor * x for x in point) for point in points)


def mixed(points: Points, key: Points, places: Sequence[int]) -> Points:
    """The key, with these components of other points."""
    return tuple(
        tuple(x if n in places else k for n, (x, k) in enumerate(zip(*pair, strict=True)))
        for pair in zip(points, key, strict=True)
    )


def rounding(point: Sequence[float]) -> float:
    """How far rounding may have moved this point: half of the last digits written."""
    return math.hypot(*(0.5 * 10.0 ** digits_written(x)[1] for x in point if x))


def most_digits(point: Sequence[float]) -> int:
    """The most digits in which a component of this point was written."""
    return max((digits_written(x)[0] for x in point if x), default=0)


@lru_cache(maxsize=64)  # several wrong models are compared with one answer
def digits_written(x: float) -> tuple[int, int]:
    """(number of digits, place of the last) of a number as it was typed: 1.25 has (3, -2)."""
    if not math.isfinite(x):
        return 0, 0
    _, digits, exponent = Decimal(repr(float(x))).as_tuple()
    assert isinstance(exponent, int)  # for mypy: the number is finite
    while len(digits) > 1 and digits[-1] == 0:  # repr writes 24.0 for 24
        digits, exponent = digits[:-1], exponent + 1
    return len(digits), exponent
