"""Motion along a line from its acceleration as a function of time or of velocity (chapter 2, with
one coordinate), to the accuracy of the numbers given, of any kind. With symbols
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
    is_comparable,
    is_numeric,
    max_abs,
    where,
    without_rates,
)


@checked
def from_time(
    a: Callable[[Scalar], Scalar], t: Scalar, x0: Scalar = ZERO, v0: Scalar = ZERO
) -> tuple[Scalar, Scalar]:
    """(x, v) at the time ``t`` for the acceleration ``a(t)``, from ``x0`` and ``v0`` at time 0.

    >>> x, v = from_time(lambda t: 6.0*t, 2.0, v0=1.0)
    >>> round(x, 12), round(v, 12)
    (10.0, 13.0)
    """
    return x0 + v0 * t + integral(lambda s: (t - s) * a(s), 0, t), v0 + integral(a, 0, t)


@checked
def from_speed(
    a: Callable[[Scalar], Scalar], v: Scalar, v0: Scalar, x0: Scalar = ZERO
) -> tuple[Scalar, Scalar]:
    """(t, x) at which a point reaches the velocity ``v`` by the acceleration ``a(v)``, starting at
    time 0 at ``x0`` with ``v0``: t is the integral of dv/a, x - x0 that of v dv/a. Raises
    :class:`SingularError` if a is zero or has the wrong sign between.

    >>> t, x = from_speed(lambda v: -0.5*v, 1.0, v0=4.0)
    >>> round(t/2, 12), round(x, 12)  # t = 2 ln 4
    (1.38629436112, 6.0)
    """
    way = without_rates(v - v0)
    ahead = where(way >= 0, 1, -1) if is_comparable(way) else 1
    # sampled: a change of sign within less than 1/64 of the interval is missed
    for n in range(65) if is_numeric(ahead) and is_numeric(v) else ():
        there = without_rates(a(v0 + (v - v0) * n / 64) * ahead)
        if is_numeric(there) and anywhere(there <= 0) and max_abs(way) > 0:
            raise SingularError(
                f"the velocity {v!r} is not reached from {v0!r}: before, a vanishes or turns"
            )
    return integral(lambda u: 1 / a(u), v0, v), x0 + integral(lambda u: u / a(u), v0, v)
