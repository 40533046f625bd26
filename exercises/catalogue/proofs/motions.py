"""Derivatives of explicit motions, by central differences."""

from collections.abc import Callable, Sequence

from mpmath import mp, mpf

from .digits import DIGITS, Matrix, Number, Orientation, Triple, Value, weighted
from .vectors import cross, plus, scaled, times, transposed

# five-point rules at 50 digits: truncation 1e-36 times the fifth derivative, rounding 1e-32
STEP = "1e-9"


def spun(axis: Sequence[Number], across: Sequence[Number], angle: Number) -> Matrix:
    """The orientation of a body that has turned on its ``axis`` by ``angle``, right-handed,
    starting from the direction ``across``.

    Both are unit vectors, at right angles. The columns are the axis and two body-fixed directions
    across it: :func:`angular_velocity` does not depend on which.
    """
    turned = plus(scaled(mp.cos(angle), across), scaled(mp.sin(angle), cross(axis, across)))
    return transposed([axis, turned, cross(axis, turned)])


def rate(f: Callable[[Number], Value], t: Number = 0) -> Value:
    """df/dt of a number, vector or matrix as a function of time: five-point central difference."""
    with mp.workdps(DIGITS):
        h, t = mpf(STEP), mpf(t)
        values = [f(t - 2 * h), f(t - h), f(t + h), f(t + 2 * h)]
        return weighted([w / (12 * h) for w in (1, -8, 8, -1)], values)


def second_rate(f: Callable[[Number], Value], t: Number = 0) -> Value:
    """d2f/dt2, by a five-point central difference."""
    with mp.workdps(DIGITS):
        h, t = mpf(STEP), mpf(t)
        values = [f(t + n * h) for n in (-2, -1, 0, 1, 2)]
        return weighted([w / (12 * h * h) for w in (-1, 16, -30, 16, -1)], values)


def angular_velocity(R: Orientation, t: Number = 0) -> Triple:
    """omega of a body with the orientation R(t) in the ground: the vector of R' R^T."""
    with mp.workdps(DIGITS):
        W = times(rate(R, t), transposed(R(mpf(t))))
        return [(W[2][1] - W[1][2]) / 2, (W[0][2] - W[2][0]) / 2, (W[1][0] - W[0][1]) / 2]


def angular_acceleration(R: Orientation, t: Number = 0) -> Triple:
    """alpha of the same body: the skew part of R'' R^T, whose symmetric part drops out."""
    with mp.workdps(DIGITS):
        W = times(second_rate(R, t), transposed(R(mpf(t))))
        return [(W[2][1] - W[1][2]) / 2, (W[0][2] - W[2][0]) / 2, (W[1][0] - W[0][1]) / 2]
