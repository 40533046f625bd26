"""How well the numbers of a wrong model fit a wrong answer: closely, loosely or not at all."""

import math
from collections.abc import Iterable, Sequence
from decimal import Decimal
from functools import cached_property
from typing import Any

from .tolerance import DIGITS, NOISE, ROUND_OFF, Point, Points, is_apart

LOOSE, CLOSE, EXACT = 1, 2, 3


class Fit:
    """Compares models with a wrong answer ``given``, a tuple of points. A model fits if it is near
    the answer at every point, and away from the key.
    """

    def __init__(self, given: Points, key: Points, rtol: float):
        self.given, self.key, self.rtol = given, key, rtol
        self.sizes = [math.hypot(*k) for k in key]
        points = range(len(key))
        self.index = next((n for n in points if math.isfinite(self.sizes[n])), None)

    def near(self, models: Iterable[tuple[Any, Points]]) -> list[tuple[Any, Points]]:
        """Those of [(cause, points)] that may fit, by one component: nearly all models do not."""
        if self.index is None:
            return []
        n, given = self.index, self.given[self.index]
        reach = 1.02 * self.rtol * math.hypot(*given) + NOISE * self.sizes[n]
        x = given[0]
        return [(cause, points) for cause, points in models if not abs(points[n][0] - x) > reach]

    @cached_property
    def rounding(point: Sequence[float]) -> float:
    """How much a student may have rounded this point by: half of the last digits written. A single
    number has three at least: as a float, 2.50 has lost its zero.
    """
    least = DIGITS if len(point) == 1 else 0
    digits = [written(x) for x in point if x]
    return math.hypot(*(0.5 * 10.0 ** (place - max(least - n, 0)) for n, place in digits))


def most_digits(point: Sequence[float]) -> int:
    """The most digits in which a component of this point was written."""
    return max((written(x)[0] for x in point if x), default=0)


def written(x: float) -> tuple[int, int]:
    """(number of digits, place of the last) of a number as it was typed: 1.25 has (3, -2)."""
    if not math.isfinite(x):
        return 0, 0
    _, digits, exponent = Decimal(repr(float(x))).as_tuple()
    assert isinstance(exponent, int)  # of a finite number
    while len(digits) > 1 and digits[-1] == 0:  # repr writes 24.0 for 24
        digits, exponent = digits[:-1], exponent + 1
    return len(digits), exponent
