"""Motion along a line from its acceleration as a function of time, of velocity or of position
(chapter 2, with one coordinate), to the accuracy of the numbers given, of any kind. With symbols
the motion is taken to go forward and to reach the value.
"""

from collections.abc import Callable

from ..algebra import integral
from ..algebra.errors import checked
from ..algebra.scalars import (
    ZERO,
    Scalar,
    SingularError,
    anywhere,
    integer_like,
    is_numeric,
    max_abs,
    scalar,
    sqrt,
    where,
    without_rates,
)


@checked
def from_time(
    a: Callable, t: Scalar, x0: Scalar = ZERO, v0: Scalar = ZERO
) -> tuple[Scalar, Scalar]:
    """(x, v) at the time ``t`` for the acceleration ``a(t)``, from ``x0`` and ``v0`` at time 0.

    >>> x, v = from_time(lambda t: 6.0*t, 2.0, v0=1.0)
    >>> round(x, 12), round(v, 12)
    (10.0, 13.0)
    """
    return x0 + v0 * t + integral(lambda s: (t - s) * a(s), 0, t), v0 + integral(a, 0, t)


@checked
def from_speed(a: Callable, v: Scalar, v0: Scalar, x0: Scalar = ZERO) -> tuple[Scalar, Scalar]:
    """(t, x) at which a point reaches the velocity ``v`` by the acceleration ``a(v)``, starting at
    time 0 at ``x0`` with ``v0``: t is the integral of dv/a, x - x0 that of v dv/a. Raises
    :class:`SingularError` if a is zero or has the wrong sign between.

    >>> t, x = from_speed(lambda v: -0.5*v, 1.0, v0=4.0)
    >>> round(t/2, 12), round(x, 12)  # t = 2 ln 4
    (1.38629436112, 6.0)
    """
    ahead = _sense(v - v0)
    # sampled: a change of sign within less than 1/64 of the interval is missed
    for n in range(65) if is_numeric(ahead) and is_numeric(v) else ():
        if _falls_below(a(v0 + (v - v0) * n / 64) * ahead, True) and max_abs(v - v0) > 0:
            raise SingularError(
                f"the velocity {v!r} is not reached from {v0!r}: the acceleration vanishes before"
            )
    return integral(lambda u: 1 / a(u), v0, v), x0 + integral(lambda u: u / a(u), v0, v)


@checked
def from_place(
    a: Callable, x: Scalar, x0: Scalar = ZERO, v0: Scalar = ZERO
) -> tuple[Scalar, Scalar]:
    """(t, v) at which a point reaches the position ``x`` by the acceleration ``a(x)``, starting at
    time 0 at ``x0`` with ``v0``, also from rest: v^2 = v0^2 + 2 (integral of a dx), t is the
    integral of dx/v. Raises :class:`SingularError` if the point turns back before ``x``; where v =
    0 at ``x`` itself the integral does not converge: start there and go backwards.

    >>> t, v = from_place(lambda x: 9.81, 2.0)
    >>> round(v**2, 9), round(9.81*t/v, 9)
    (39.24, 1.0)
    """
    distance = scalar(x) - x0
    forward = _sense(distance)

    def speed(s):
        # s is the distance from the start: x0 + s would lose digits near it
        square = v0 * v0 + 2 * s * integral(lambda p: a(x0 + s * p), 0, integer_like(1, s))
        if _falls_below(square):
            raise SingularError(
                f"the point does not reach x = {x!r}: v^2 becomes negative on the way"
            )
        return sqrt(square)

    if _falls_below(v0 * forward):
        raise SingularError(
            f"the point starts away from x = {x!r} (v0 = {v0!r}); follow it to its turn first"
        )
    return integral(lambda s: forward / speed(s), 0, distance), forward * speed(distance)


def _sense(x):
    """1 where x is not negative, else -1; 1 for dimensions and symbols, which have no sign."""
    x = without_rates(x)
    return where(x >= 0, 1, -1) if is_numeric(x) or hasattr(x, "where") else 1


def _falls_below(x, or_equals=False):
    """Whether a number is negative at any instant; False for expressions."""
    x = without_rates(x)
    return is_numeric(x) and anywhere(x <= 0 if or_equals else x < 0)
