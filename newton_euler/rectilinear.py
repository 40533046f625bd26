"""Motion along a line from its acceleration, given as a function of time, of speed or of place (ch. 2, with one coordinate).

The acceleration is dv/dt, and v = dx/dt, so that also a = v dv/dx. Each function here integrates one of these once or twice, to the
accuracy of the numbers it gets (floats, arrays, mpf). For formulas integrate by hand or with SymPy.
"""

from .scalars import ScalarError, cosh, epsilon, exp, is_numeric, pi, scalar, sinh, size, sqrt, where
from .triads import SingularError


def from_time(a, t, x0=0.0, v0=0.0):
    """(x, v) at the time ``t`` of a point that at time 0 is at ``x0`` with velocity ``v0``; ``a`` is its acceleration as a function of time.

    >>> x, v = from_time(lambda t: 6.0*t, 2.0, v0=1.0)
    >>> round(x, 12), round(v, 12)
    (10.0, 13.0)
    """
    return x0 + v0 * t + integral(lambda s: (t - s) * a(s), 0 * t, t), v0 + integral(a, 0 * t, t)


def from_speed(a, v, v0, x0=0.0):
    """(t, x) at which a point reaches the velocity ``v``, starting at time 0 at ``x0`` with ``v0``.

    a : the acceleration as a function of velocity. t is the integral of dv/a, x - x0 that of v dv/a. Raises :class:`SingularError` if the
    acceleration vanishes or changes its sign in between, or opposes the change, so that ``v`` is not reached.

    >>> t, x = from_speed(lambda v: -0.5*v, 1.0, v0=4.0)
    >>> round(t/2, 12), round(x, 12)  # t = 2 ln 4
    (1.38629436112, 6.0)
    """
    _check_reached(a, v, v0)
    return integral(lambda u: 1 / a(u), v0, v), x0 + integral(lambda u: u / a(u), v0, v)


def from_place(a, x, x0=0.0, v0=0.0):
    """(t, v) at which a point reaches the place ``x``, starting at time 0 at ``x0`` with ``v0``.

    a : the acceleration as a function of place. v^2 = v0^2 + 2 (integral of a dx), t is the integral of dx/v, also from rest. Raises
    :class:`SingularError` if v^2 would be negative: the point turns back before ``x``. Where v = 0 at ``x`` itself the integral does not settle:
    start there and go backwards.

    >>> t, v = from_place(lambda x: 9.81, 2.0)
    >>> round(v**2, 9), round(9.81*t/v, 9)
    (39.24, 1.0)
    """
    way = scalar(x) - x0
    forward = where(way >= 0, 1, -1)

    def speed(s):
        """At the distance s from the start; s is small near the start, where x0 + s would lose digits."""
        square = v0 * v0 + 2 * s * integral(lambda p: a(x0 + s * p), 0 * s, 0 * s + 1)
        if size(where(square < 0, 1, 0)) > 0:
            raise SingularError(f"the point does not reach x = {x!r}: v^2 becomes negative on the way, so it turns back before")
        return sqrt(square)

    if size(where(v0 * forward < 0, 1, 0)) > 0:
        raise SingularError(f"the point starts away from x = {x!r} (v0 = {v0!r}); follow it to its turning point first")
    return integral(lambda s: forward / speed(s), 0 * way, way), forward * speed(way)


def _check_reached(a, v, v0):
    ahead = where(v >= v0, 1, -1)
    for n in range(65):
        if size(where(a(v0 + (v - v0) * n / 64) * ahead <= 0, 1, 0)) > 0 and size(v - v0) > 0:
            raise SingularError(f"the velocity {v!r} is not reached from {v0!r}: the acceleration vanishes or points the other way in between")


def integral(f, start, end):
    """The integral of ``f`` from ``start`` to ``end``, by the tanh-sinh rule, to nearly the accuracy of the numbers.

    f may be infinite at ``start`` = 0 if integrable, as x**-0.5, but at no other end. Arrays are many integrals at once.
    Raises :class:`SingularError` if the rule does not settle (f jumps, or oscillates too fast), and :class:`ScalarError` for expressions.

    >>> integral(lambda x: x**-0.5, 0.0, 4.0) - 4 < 1e-14
    True
    """
    if not (is_numeric(start) and is_numeric(end)):
        raise ScalarError(f"an integral from {start!r} to {end!r} needs numbers; of an expression take the integral by hand or with SymPy")
    width, small = end - start, epsilon(end - start)
    nearest = small * small if size(start) == 0 else small  # next to 0 nodes are told apart to the last
    total, step, before = _sum(f, start, width, small / small, None, small, nearest), small / small, None
    allowed = 1e-3 * sqrt(small) * size(width * _sum(lambda x: abs(f(x)), start, width, step, None, small, nearest))
    for _ in range(9):
        total, step = total + _sum(f, start, width, step / 2, step, small, nearest), step / 2
        value = total * step * width
        if before is not None and size(value - before) <= allowed:  # the next halving squares the error
            return value
        before = value
    raise SingularError(f"the integral from {start!r} to {end!r} does not settle; is the function smooth in between? Split it where it is not")


def _sum(f, start, width, first, step, small, nearest):
    """Weight times f over the nodes at t = ±first, ±(first + step), … ; without a step those at 0, ±1, ±2, …"""
    total, t = (0, first) if step else (pi(first) / 4 * f(start + width / 2), first)
    while True:
        near = 1 / (1 + exp(pi(t) * sinh(t)))  # fraction of the way from the start; 1 - near is its mirror image
        if near < nearest:
            return total
        weight = pi(t) * cosh(t) * near * (1 - near)
        total = total + weight * f(start + width * near)
        if near > small:
            total = total + weight * f(start + width * (1 - near))
        t = t + (step or first)
