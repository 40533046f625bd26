"""How far a top nods: the limits of nutation, from its state at one instant (10.24), (10.25).

With I omega_z and the momentum about the vertical constant, the energy makes u = cos(theta) move in a cubic potential: u'^2 = f(u), and the limits
are the two roots of f in [-1, 1]. Looking for them in f(u) loses half of the digits at small nutations and near the vertical. Here
f is written twice without cancellation: in the distance from the start, where it is small, and in the distance from the pole.

>>> found = nutation(0.02, 0.01, mgr=0.5, theta=1.0, theta_rate=0.0, precession=0.0, spin=100.0)  # released at rest
>>> found.kind, round(found.theta_max - found.theta_min, 6)
('cusps', 0.017103)
"""

import math
from dataclasses import dataclass

from .gyros import GyroError, _check_moments
from .scalars import atan2, cos, epsilon, is_numeric, pi, plain, scalar, sin, size, sqrt, where


@dataclass(frozen=True)
class Nutation:
    """What :func:`nutation` finds; rad, rad/s, s.

    theta_min, theta_max : the limits between which the axis nods
    precession_at_min, precession_at_max : psi' at these; nan at the vertical, where it has none
    kind : "waves", the precession keeps its sense; "loops", it reverses; "cusps", it stops at one of the limits, as when released from rest;
        "steady", the limits are one; "through the vertical"; "planar", a pendulum in a plane. For arrays a list of these.
    period : of one nod, down and up; infinite for a motion that creeps up to the vertical
    """

    theta_min: object
    theta_max: object
    precession_at_min: object
    precession_at_max: object
    kind: object
    period: object


def nutation(I0, I, mgr, theta, theta_rate, precession, spin=None, omega_z=None, tolerance=1e-9):
    """The limits of nutation of a top with this state, to round-off: a :class:`Nutation`. Angles and rates as in :mod:`newton_euler.gyros`.

    spin or omega_z : phi', or the whole rate about the axis; give one of them
    tolerance : relative, when a limit counts as a cusp, and in rad, when the motion counts as steady or as reaching the vertical; the numbers are not
        affected by it
    For floats, mpf and arrays; raises :class:`GyroError` for expressions, whose cubic has no order of its roots.
    """
    _check_moments(I0, I)
    if (spin is None) == (omega_z is None):
        raise GyroError("give either spin, the rate phi' about the axis relative to the precessing plane, or omega_z = phi' + psi' cos(theta)")
    b = I * (omega_z if spin is None else spin + precession * cos(theta)) / I0
    A = 2 * mgr / I0
    given = [plain(scalar(x)) for x in (A, b, theta, theta_rate, precession)]
    if not all(map(is_numeric, given)):
        raise GyroError("the limits of nutation need numbers: the roots of a cubic with expressions have no order; put in values first")
    A, b, theta, q, n = (x + 0 * sum(given) for x in given)
    half_s, half_c = sin(theta / 2), cos(theta / 2)
    v, w, s2 = 2 * half_s * half_s, 2 * half_c * half_c, sin(theta) ** 2  # 1 - u, 1 + u, 1 - u^2
    up, v1 = _limit(v, w, s2, q, n, A, b)  # how far u rises, what is left to the pole
    down, w1 = _limit(w, v, s2, q, n, -A, -b)
    limits = _angle(v1, 2 - v1), _angle(2 - w1, w1)
    momenta = n * s2 - b * up, n * s2 + b * down  # psi' sin^2(theta) at the limits
    from_pole = limits[0], pi(limits[0]) - limits[1]
    rates = [_rate(m, x * (2 - x), angle, tolerance) for m, x, angle in zip(momenta, (v1, w1), from_pole, strict=True)]
    kind = _classify(*limits, *momenta, abs(n) * s2 + abs(b) * (up + down), tolerance, pi(theta))
    return Nutation(*limits, *rates, kind, _period(up, down, A, b, q, n, v, w, s2))


def _limit(v, w, s2, q, n, A, b):
    """How far the axis can go towards the pole that is ``v`` away, as the change of cos(theta), and what is left of v.

    v, w : 1 - u and 1 + u at the start for the upper pole; exchanged for the lower one, with the signs of A and b
    """
    kinetic = q * q + n * n * s2
    c1 = (v - w) * q * q + s2 * (2 * b * n + (v - w) * n * n - A)
    c2 = (w - v) * A - kinetic - b * b
    at_pole = n * s2 - b * v

    def near_start(x):  # f at the distance x from the start
        return s2 * q * q + x * (c1 + x * (c2 + x * A))

    def near_pole(y):  # f at the distance y from the pole
        momentum = at_pole + b * y
        return y * (2 - y) * (kinetic - A * (v - y)) - momentum * momentum

    half = v / 2
    passed = near_pole(half) > 0
    x, y = _edge(lambda x: near_start(x) > 0, 0 * half, half), _edge(lambda y: near_pole(y) > 0, half, 0 * half)
    return where(passed, v - y, x), where(passed, y, v - x)


def _edge(inside, start, end):
    """By bisection, to the last digit even where it is tiny, the last place towards ``end`` that is inside; ``start`` if no other one is."""
    for _ in range(int(-4 * math.log2(size(epsilon(start))))):
        middle = (start + end) / 2
        reached = inside(middle)
        start, end = where(reached, middle, start), where(reached, end, middle)
    return start


def _angle(v, w):
    return 2 * atan2(sqrt(v), sqrt(w))


def _rate(momentum, s2, angle, tolerance):
    """psi' from psi' sin^2(theta); nan at the vertical."""
    none = angle <= tolerance
    return where(none, math.nan, momentum / where(none, 1, s2))


def _classify(theta_min, theta_max, at_min, at_max, scale, tolerance, pi):
    if getattr(theta_min, "shape", ()):
        columns = zip(*(x.tolist() for x in (theta_min, theta_max, at_min, at_max, scale)), strict=True)
        return [_classify(*column, tolerance, pi) for column in columns]
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


def _period(up, down, A, b, q, n, v, w, s2):
    """2 pi over the arithmetic-geometric mean of the square roots of f/((u - u1)(u2 - u)) at both limits."""
    middle = (v - w) * A + q * q + n * n * s2 + b * b
    first, last = middle + A * (2 * down - up), middle + A * (down - 2 * up)
    none = where(first <= 0, 1, where(last <= 0, 1, 0)) == 1
    x, y = (sqrt(where(none, 1, value)) for value in (first, last))
    for _ in range(16):
        x, y = (x + y) / 2, sqrt(x * y)
    return where(none, math.inf, 2 * pi(x) / x)
