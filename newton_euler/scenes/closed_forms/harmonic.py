"""Motion under a constant acceleration, or one proportional to a distance; Stumpff's series."""

from collections.abc import Callable, Mapping
from typing import Any

from ...algebra.portable import Values
from ...algebra.scalars import ZERO, Scalar, Triple, cos, cosh, epsilon, exp, sin, sinh, sqrt, where
from ...motion.model import Model


def uniform_acceleration(x: Scalar, v: Scalar, a: Scalar, t: Scalar) -> tuple[Scalar, Scalar]:
    """x and its rate at the time t if x'' = a, from x and v at t = 0."""
    return x + (v + a * t / 2) * t, v + a * t


def constant_rate(
    name: str,
    parameters: Mapping[str, Scalar],
    of: Callable[[Values], Scalar],
    *states: str,
    **about: Any,
) -> Model:
    """The Model of x, if among the ``states``, and its rate, which has the constant rate of(p)."""

    def rates(s, p, t):
        return *(getattr(s, n) for n in states[1:]), of(p)

    def exact(s, p, t):
        *x, v = (getattr(s, n) for n in states)
        return uniform_acceleration(*x, v, of(p), t) if x else (v + of(p) * t,)

    return Model(name, parameters, states, rates, exact=exact, **about)


def integrated_square(v: Scalar, a: Scalar, t: Scalar) -> Scalar:
    """The double integral of (v + a t)^2: at most, what a drag of v^2 per m takes off the way."""
    return t * t * (v * v / 2 + v * a * t / 3 + a * a * (t * t) / 12)


def oscillation(
    x: Scalar, v: Scalar, square: Scalar, t: Scalar, damping: Scalar = ZERO
) -> tuple[Scalar, Scalar]:
    """x and its rate at the time t if x'' = -square x - damping x'; square > (damping/2)^2.

    >>> [round(q, 9) for q in oscillation(1.0, 0.0, 4.0, 0.25)]  # cos(2 t), -2 sin(2 t)
    [0.877582562, -0.958851077]
    """
    half = damping / 2
    n, decay = sqrt(square - half * half), exp(-half * t)
    c, S = decay * cos(n * t), decay * sin(n * t) / n
    return x * (c + half * S) + v * S, v * (c - half * S) - square * x * S


def plane_oscillation(
    s: Values, square: Scalar, t: Scalar, damping: Scalar = ZERO
) -> tuple[Scalar, ...]:
    """x, y, dx, dy at t if both coordinates oscillate so, from the states ``s`` at t = 0."""
    x, dx = oscillation(s.x, s.dx, square, t, damping)
    y, dy = oscillation(s.y, s.dy, square, t, damping)
    return x, y, dx, dy


def rotated(x: Scalar, y: Scalar, angle: Scalar) -> tuple[Scalar, Scalar]:
    """The components x, y of a vector that is turned by the angle, counterclockwise."""
    c, s = cos(angle), sin(angle)
    return c * x - s * y, c * y + s * x


def growth(n: Scalar, t: Scalar) -> Triple:
    """cosh(n t), sinh(n t)/n and (cosh(n t) - 1)/n^2: x at t if x'' = n^2 x + a, for a start at 1,
    a rate of 1, and a = 1.

    >>> [round(q, 9) for q in growth(2.0, 0.25)]
    [1.127625965, 0.260547653, 0.031906491]
    """
    half = sinh(n * t / 2) / n  # cosh(x) - 1 = 2 sinh(x/2)^2 without cancellation
    return cosh(n * t), sinh(n * t) / n, 2 * half * half


def circular_or_hyperbolic(square: Scalar, t: Scalar) -> tuple[Scalar, Scalar]:
    """cos(n t) and sin(n t)/n with n^2 = ``square`` of any sign; for numbers and traced values.

    >>> circular_or_hyperbolic(0.0, 3.0)
    (1.0, 3.0)
    """
    grows, n = square < 0, sqrt(abs(square))
    turned, grown = where(grows, 0, n * t), where(grows, n * t, 0)
    c, S = where(grows, cosh(grown), cos(turned)), where(grows, sinh(grown), sin(turned))
    return c, where(n > 0, S / where(n > 0, n, 1), t)


def stumpff(k: int, z: Scalar, largest: float = 1) -> Scalar:
    """k! times Stumpff's function c_k(z) = 1/k! - z/(k + 2)! + z^2/(k + 4)! - ..., by as many terms
    as |z| <= ``largest`` takes to round-off (K. Stumpff, Himmelsmechanik I, 1959).

    c_0(x^2) = cos(x), c_1(x^2) = sin(x)/x, x^2 c_2(x^2) = 1 - cos(x), x^3 c_3(x^2) = x - sin(x).

    >>> round(0.5**3*stumpff(3, 0.25)/6 - (0.5 - sin(0.5)), 16)
    0.0
    """
    term, last = 1.0, k
    while (term := term * largest / ((last + 1) * (last + 2))) > epsilon(z) / 4:
        last += 2
    total = 1
    for n in range(last, k, -2):
        total = 1 - z / (n * (n - 1)) * total
    return total
