"""The limits of nutation of a top, from its state at one instant (10.24), (10.25).

u = cos(theta) moves in a cubic potential, u'^2 = f(u), between two roots of f in [-1, 1], which
lose half of their digits at small nutations and near the vertical if f(u) = 0 is solved. Here the
third root is computed, far from both, and from it their distances from the initial state and from
the vertical, without cancellation.

>>> released = {"theta": 1.0, "theta_rate": 0.0, "precession": 0.0, "spin": 100.0}
>>> found = nutation(0.02, 0.01, mgr=0.5, **released)
>>> found.kind, round(found.theta_max - found.theta_min, 6)
('cusps', 0.017103)
"""

import math
from dataclasses import dataclass

from ..algebra.scalars import (
    Scalar,
    acos,
    allowed,
    atan2,
    cos,
    is_numeric,
    pi,
    promote,
    scalar,
    sin,
    sqrt,
    where,
)
from .gyroscopes import GyroError, check_top


@dataclass(frozen=True)
class Nutation:
    """The nutation of a top, by :func:`nutation`; rad, rad/s, s.

    theta_min, theta_max : the limits between which the axis nutates
    precession_at_min, precession_at_max : psi' at these; nan at the vertical, where it is undefined
    kind : "waves", the precession keeps its sense; "loops", it reverses; "cusps", it stops at a
        limit, as when released from rest; "steady", the limits are equal; "through the vertical";
        "planar", a pendulum in a plane. For arrays a list of these.
    period : of one nutation, down and up; infinite for a motion that tends to the vertical
    """

    theta_min: Scalar
    theta_max: Scalar
    precession_at_min: Scalar
    precession_at_max: Scalar
    kind: str | list
    period: Scalar


def nutation(
    I0: Scalar,
    I: Scalar,
    mgr: Scalar,
    theta: Scalar,
    theta_rate: Scalar,
    precession: Scalar,
    spin: Scalar = None,
    omega_z: Scalar = None,
    tolerance: float = 1e-9,
) -> Nutation:
    """The limits of nutation of a top in this state, to round-off; arguments as in
    :mod:`newton_euler.applications.gyroscopes`, either ``spin`` or ``omega_z``.

    tolerance : relative, when a limit counts as a cusp, and in rad, when the motion counts as
        steady or as reaching the vertical; the numbers are not affected by it
    For floats, mpf and arrays; raises :class:`GyroError` for expressions.
    """
    check_top(I0, I, spin, omega_z)
    tolerance = allowed(tolerance)
    b = I * (omega_z if spin is None else spin + precession * cos(theta)) / I0
    given = promote(*map(scalar, (b, mgr / I0, theta, theta_rate, precession)))
    if not all(map(is_numeric, given)):
        raise GyroError("the limits of nutation need numbers: put in values first")
    # below, all momenta and the pull of gravity are divided by I0
    b, pull, theta, q, n = given
    S, C = sin(theta / 2), cos(theta / 2)
    sine, cosine = 2 * (S * C), C * C - S * S
    momenta = 2 * (S * S) * (2 * n * (C * C) - b), 2 * (C * C) * (2 * n * (S * S) + b)
    hanging = pull < 0  # seen from below it is a top with pull > 0: theta and pi - theta exchanged
    change = where(hanging, -1, 1) * sine * (n * cosine - b)
    s, c = exchanged(hanging, S, C)
    momenta = exchanged(hanging, *momenta)
    moved, left, zeta = turning_points(s, c, q, 1, abs(pull), momenta, (n * sine, change))
    (up, down), (v1, w2) = exchanged(hanging, *moved), exchanged(hanging, *left)
    low, high = _angle(v1, 2 - v1), _angle(2 - w2, w2)
    still = n * sine * sine
    at_low, at_high = still - b * up, still + b * down  # psi' sin^2(theta)
    scale = abs(still) + abs(b) * (up + down)
    return Nutation(
        low,
        high,
        _rate(at_low, v1 * (2 - v1), low, tolerance),
        _rate(at_high, w2 * (2 - w2), pi(theta) - high, tolerance),
        _classify(low, high, at_low, at_high, scale, tolerance, pi(theta)),
        _period(2 * (zeta + abs(pull) * left[0]), 2 * (zeta + abs(pull) * (2 - left[1]))),
    )


def exchanged(condition: Scalar, x: Scalar, y: Scalar) -> tuple[Scalar, Scalar]:
    """The pair, exchanged where the condition holds."""
    return where(condition, y, x), where(condition, x, y)


def turning_points(
    S: Scalar,
    C: Scalar,
    rate: Scalar,
    I0: Scalar,
    mgr: Scalar,
    momenta: tuple[Scalar, Scalar],
    transverse: tuple[Scalar, Scalar],
) -> tuple[tuple, tuple, Scalar]:
    """The distances of v = 1 - cos(theta) from its limits, (v - v1, v2 - v), those of the limits
    from 0 and 2, (v1, 2 - v2), and zeta; mgr >= 0. I0 v'^2/2 = F(v), a cubic with the roots v1, v2,
    -zeta/mgr.

    S, C, rate : sin(theta/2), cos(theta/2) and theta' now
    momenta : the angular momentum about the vertical less that about the axis, q, and their sum
    transverse : I0 psi' sin(theta), which is q/(2 tan(theta/2)) plus the sum times tan(theta/2)/2,
        and the difference of these two
    """
    (q, whole), (across, change) = momenta, transverse
    v, h = 2 * (S * S), (whole - q) / 2
    kinetic = (I0 * (rate * rate) + across * across / I0) / 2
    zeta = _third_root(kinetic - mgr * v, h * h / (2 * I0), h * q / I0, q * q / (2 * I0), mgr)
    # F = (v - v1)(v2 - v)(zeta + mgr v): its value and slope now give the product and the
    # difference of the two distances; a zero divisor is replaced by 1, its numerator is zero too
    Z = zeta + mgr * v
    over = where(Z > 0, Z, 1)
    product = I0 * (2 * (S * C) * rate) ** 2 / (2 * over)
    slope = I0 * (rate * rate) * (C * C - S * S) + mgr * (2 * (S * C)) ** 2 + across * change / I0
    X, Y = _between(product, (slope - mgr * product) / over)
    # F(0) and F(2) give v1 and 2 - v2 as quotients; v - X would cancel near the vertical
    lowest = 2 * I0 * zeta * (v + Y)
    v1 = where(lowest > 0, q * q / where(lowest > 0, lowest, 1), v - X)
    highest = 2 * I0 * (2 * (C * C) + X) * (2 * mgr + zeta)
    w2 = where(highest > 0, whole * whole / where(highest > 0, highest, 1), 2 * (C * C) - Y)
    return (X, Y), (v1, w2), zeta


def _third_root(e, spin, cross, rest, mgr):
    """The root zeta >= 0 of (zeta - e) zeta (zeta + 2 mgr) = spin zeta^2 - cross mgr zeta + rest
    mgr^2: Viete's solution for the largest root, a quadratic for the two others.
    """
    a, b, c = 2 * mgr - e - spin, mgr * (cross - 2 * e), -rest * (mgr * mgr)
    square = (a * a - 3 * b) / 9
    P = sqrt(where(square > 0, square, 0 * square))
    cube, turned = P * P * P, a > 0
    cosine = (abs(a) * (a * a / 27 - b / 6) + where(turned, c, -c) / 2) / where(cube > 0, cube, 1)
    cosine = where(cosine > 1, 1, where(cosine < -1, -1, cosine))  # it may exceed 1 by round-off
    largest = abs(a) / 3 + 2 * P * cos(acos(cosine + 0 * P) / 3)
    under = where(largest > 0, largest, 1)
    product = -c / under
    half = (b + product) / (2 * under)
    root = sqrt(half * half + product)
    # half - root cancels for half > 0; there the product of the roots gives it
    other = where(half > 0, product / where(half + root > 0, half + root, 1), root - half)
    return where(turned, other, largest)


def _between(product, difference):
    """The two numbers >= 0 with this product, and this difference of the second and the first."""
    # the larger by a sum, the smaller as a quotient: their difference would cancel
    larger = (abs(difference) + sqrt(difference * difference + 4 * product)) / 2
    smaller = product / where(larger > 0, larger, 1)
    return where(difference > 0, smaller, larger), where(difference > 0, larger, smaller)


def _angle(v, w):
    return 2 * atan2(sqrt(v), sqrt(w))


def _rate(momentum, s2, angle, tolerance):
    """psi' from psi' sin^2(theta); nan at the vertical."""
    none = angle <= tolerance
    return where(none, math.nan, momentum / where(none, 1, s2))


def _classify(theta_min, theta_max, at_min, at_max, scale, tolerance, pi):
    if getattr(theta_min, "shape", ()):
        given = (x.tolist() for x in (theta_min, theta_max, at_min, at_max, scale))
        return [_classify(*column, tolerance, pi) for column in zip(*given, strict=True)]
    small, large = sorted((abs(at_min), abs(at_max)))
    if theta_max - theta_min <= tolerance:
        return "steady"
    if large <= tolerance * scale:
        return "planar"
    if theta_min <= tolerance or pi - theta_max <= tolerance:
        return "through the vertical"
    if small <= tolerance * large:
        return "cusps"
    return "loops" if (at_min > 0) != (at_max > 0) else "waves"


def _period(x, y):
    """2 pi over the mean of sqrt(F/((v - v1)(v2 - v)) 2/I0) at both limits; inf where 0."""
    none = where(x > 0, where(y > 0, 1, 0), 0) == 0
    x, y = (sqrt(where(none, 1, value)) for value in (x, y))
    for _ in range(16):  # it converges quadratically: enough for hundreds of digits
        x, y = (x + y) / 2, sqrt(x * y)
    return where(none, math.inf, 2 * pi(x) / x)
