"""Sums and products with twice the digits, for differences in which the digits cancel (T. J.
Dekker, Numerische Mathematik 18, 224, 1971).

They need only the arithmetic of their numbers, and no branches, so that they run on floats and
arrays, traced, and through heyoka; an mpf instead takes more digits of its own.
"""

from collections.abc import Callable
from typing import Any

from ...algebra.scalars import ZERO, Scalar, with_extra_digits

SPLITTER = 2.0**27 + 1  # cuts the 53 digits of a double in two halves


def doubled(f: Callable[..., Any], *values: Scalar) -> Scalar:
    """``f(*values)`` for sums, differences and products of numbers taken as exact, computed with
    twice their digits or more and rounded once.

    >>> a, b = 1 + 2.0**-30, 1 - 2.0**-30
    >>> a*b - 1.0, doubled(lambda a, b, one: a*b - one, a, b, 1.0) == -(2.0**-60)
    (0.0, True)
    """
    if any(type(x).__module__.startswith("mpmath") for x in values):
        return with_extra_digits(f, *values)
    found = f(*(Doubled(x) for x in values))
    return found.high + found.low


class Doubled:
    """``high + low``, the second within the round-off of the first."""

    __slots__ = ("high", "low")

    def __init__(self, high: Scalar, low: Scalar = ZERO):
        self.high, self.low = high, low

    def __add__(self, other: "Doubled") -> "Doubled":
        high, low = _sum(self.high, other.high)
        return Doubled(*_sum(high, low + (self.low + other.low)))

    def __sub__(self, other: "Doubled") -> "Doubled":
        return self + Doubled(-other.high, -other.low)

    def __mul__(self, other: "Doubled") -> "Doubled":
        high, low = _product(self.high, other.high)
        return Doubled(*_sum(high, low + (self.high * other.low + self.low * other.high)))


def _sum(a, b):
    """a + b, and by how much it was rounded."""
    s = a + b
    grown = s - a
    return s, (a - (s - grown)) + (b - grown)


def _product(a, b):
    """a b, and by how much it was rounded."""
    p = a * b
    (a, c), (b, d) = _halves(a), _halves(b)
    return p, ((a * b - p) + a * d + c * b) + c * d


def _halves(a):
    scaled = SPLITTER * a
    high = scaled - (scaled - a)
    return high, a - high
