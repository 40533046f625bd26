"""One test over many kinds of number.

    from tests.kinds import close, every_kind, numbers

    @every_kind
    def test_a_law(kind):
        x, y = numbers(kind, 0.3, "1/3")
        assert close(sin(x)**2 + cos(x)**2, 1)

A test that looks at values converts its results with :func:`number`; one that must not branch on
them stays as it is.
"""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy

from newton_euler import Dimension, at, compiled
from newton_euler.algebra.scalars import to_plain

mpmath.mp.dps = 30  # every mpf of the tests has 30 digits


def _array(x):
    """The value and two near it, so that a formula which mixes up instants is seen."""
    return float(x) * np.array([1.0, 1.0625, 0.875])


def _mpf(x):
    return mpmath.mpf(x.numerator) / x.denominator


def _rational(x):
    return sympy.Rational(x.numerator, x.denominator)


# each makes its number from a Fraction
KINDS = {"float": float, "array": _array, "mpmath": _mpf, "sympy": _rational}
every_kind = pytest.mark.parametrize("kind", KINDS)
MASS, LENGTH, TIME = Dimension(1, 0, 0), Dimension(0, 1, 0), Dimension(0, 0, 1)


def numbers(kind, *values):
    """The values (int, float, Fraction, or text as "1/3") as numbers of this kind; a single one not
    in a tuple.

    A float is taken for the decimal number it is written as: 0.1 becomes 1/10 in mpmath and SymPy.
    """
    out = tuple(KINDS[kind](Fraction(str(v))) for v in values)
    return out[0] if len(out) == 1 else out


def number(x):
    """A scalar of any kind, for comparison: a 30-digit mpf, or an array of floats for an array."""
    x = to_plain(x)
    if isinstance(x, np.ndarray):
        return x
    if isinstance(x, sympy.Basic):
        x = x.evalf(30)
        return mpmath.mpf(x._mpf_) if x.is_Float else mpmath.mpf(str(x))
    return mpmath.mpf(x)


def rates(f, t):
    """The rate of each of the numbers that the function ``f`` of time gives at t, called once."""
    time = at(lambda t: t, t)
    return [(x + 0 * time).rate for x in f(time)]


def within(floats, digits):
    """The tolerance of a kind, times a scale: ``floats``, or 10^-digits where digits are free."""
    return lambda kind, scale=1: (
        scale * (floats if kind in ("float", "array") else mpmath.mpf(10) ** -digits)
    )


small = within(1e-12, 25)


def close(a, b, tolerance=1e-12):
    """True if a and b (scalars of any kind, vectors, or nested tuples of them) differ by at most
    ``tolerance``, absolute, everywhere.

    Vectors of two frames are compared in the frame of ``a``; a vector may be compared with a triple
    of components.
    """
    if hasattr(a, "frame") and hasattr(b, "frame"):
        b = b.expressed_in(a.frame)
    if hasattr(a, "frame") or isinstance(a, (tuple, list)):
        a, b = tuple(a), tuple(b)
        return len(a) == len(b) and all(close(x, y, tolerance) for x, y in zip(a, b, strict=True))
    return bool(np.all(abs(number(a) - number(b)) <= tolerance))


def first(x):
    """The value of a scalar, or the first of an array: one instant of any kind."""
    return x[0] if isinstance(x, np.ndarray) and x.shape else x


def compiled_by(backend, f):
    """The formula ``f``, compiled: its arrays go by "numpy" or "heyoka" alone, or "auto"."""
    run = compiled(f)
    run.seen += {"numpy": -math.inf, "heyoka": math.inf, "auto": 0}[backend]
    return run
