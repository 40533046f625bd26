"""The exact solution of the nutation of a symmetric top (10.24), by elliptic functions.

With v = 1 - cos(theta) the energy gives I0 v'^2/2 = F(v), a cubic with the roots v1 and v2, between which v moves, and -zeta/mgr. The square roots of
v - v1, v2 - v and zeta + mgr v change at rates that are products of the two others. A top that is pulled up is one that is pulled down, seen from
below.
"""

from .elliptic import counted, coupled
from .models import comparable
from .scalars import acos, cos, sin, sqrt, where, whole


def nutation_exact(s, p, t):
    """theta and its rate at the time t after the state ``s`` of :func:`newton_euler.scenes.top.nutation`, whose parameters are ``p``."""
    given = s.theta, s.theta_rate, p.I0, p.I, p.mgr, p.omega_z, p.momentum_difference, t
    theta, rate, I0, I, mgr, omega_z, q, t = comparable("top", *given)
    whole, below, start = 2 * (I * omega_z) + q, mgr < 0, (cos(theta / 2), sin(theta / 2))

    def seen(x, y):
        return where(below, y, x), where(below, x, y)

    (S, C), sides = seen(start[1], start[0]), seen(q, whole)
    S1, C1, rate1, phase = _nutation(S, C, where(below, -rate, rate), I0, abs(mgr), *sides, t)
    sine, cosine = seen(S1, C1)
    phase = where(rate < 0, -phase, phase)
    return 2 * counted(theta / 2, start, (cosine, sine), phase), where(below, -rate1, rate1)


def _nutation(S, C, rate, I0, mgr, q, whole, t):
    """sin(theta/2), cos(theta/2), theta' and the mean phase of turning (0 unless it turns over) at t, from those of the start; mgr >= 0."""
    v, h = 2 * (S * S), (whole - q) / 2
    rest, sum_ = q * C / (2 * where(abs(q) > 0, S, 1)), whole * S / (2 * where(abs(whole) > 0, C, 1))
    kinetic = (I0 * (rate * rate) + (rest + sum_) * (rest + sum_) / I0) / 2
    zeta = _farthest_root(kinetic - mgr * v, h * h / (2 * I0), h * q / I0, q * q / (2 * I0), mgr)
    Z = zeta + mgr * v
    over = where(Z > 0, Z, 1)
    product = I0 * (2 * (S * C) * rate) ** 2 / (2 * over)
    slope = I0 * (rate * rate) * (C * C - S * S) + mgr * (2 * (S * C)) ** 2 + (rest + sum_) * (rest - sum_) / I0
    X, Y = _between(product, (slope - mgr * product) / over)
    lowest = 2 * I0 * zeta * (v + Y)
    v1 = where(lowest > 0, q * q / where(lowest > 0, lowest, 1), v - X)
    highest = 2 * I0 * (2 * (C * C) + X) * (2 * mgr + zeta)
    v2 = where(highest > 0, whole * whole / where(highest > 0, highest, 1), 2 * (C * C) - Y)  # below the downward vertical
    k = 1 / sqrt(2 * I0)
    start = _signed(sqrt(X), S), _signed(sqrt(Y), C), _signed(sqrt(Z), rate)
    x, y, z, phase = coupled((k, -k, k * mgr), start, -(zeta + mgr * v1) / (2 * I0), t)
    S1, slant = _off(v1, x, S)
    C1, slant2 = _off(v2, y, C)
    return S1, C1, 2 * k * z * (slant * slant2), where(v1 > 0, 0, where(v2 > 0, 0, phase))


def _farthest_root(e, spin, cross, rest, mgr):
    """The root zeta >= 0 of (zeta - e) zeta (zeta + 2 mgr) = spin zeta^2 - cross mgr zeta + rest mgr^2, the others being none.

    By the cosine for the root of the largest size, which is well-conditioned, and the quadratic that is left for the two others, of opposite signs.
    """
    a, b, c = 2 * mgr - e - spin, mgr * (cross - 2 * e), -rest * (mgr * mgr)
    square = (a * a - 3 * b) / 9
    P = sqrt(where(square > 0, square, 0 * square))
    cube, turned = P * P * P, a > 0
    cosine = (abs(a) * (a * a / 27 - b / 6) + where(turned, c, -c) / 2) / where(cube > 0, cube, 1)
    cosine = where(cosine > 1, 1, where(cosine < -1, -1, cosine))
    largest = abs(a) / 3 + 2 * P * cos(acos(cosine + 0 * P) / 3)
    under = where(largest > 0, largest, 1)
    product = -c / under
    half = (b + product) / (2 * under)
    root = sqrt(half * half + product)
    other = where(half > 0, product / where(half + root > 0, half + root, 1), root - half)
    return where(turned, other, largest)


def _between(product, difference):
    """The two numbers >= 0 of this product, and difference of the second and the first."""
    larger = (abs(difference) + sqrt(difference * difference + 4 * product)) / 2
    smaller = product / where(larger > 0, larger, 1)
    return where(difference > 0, smaller, larger), where(difference > 0, larger, smaller)


def _signed(x, like):
    return where(like < 0, -x, x)


def _off(least, x, like):
    """The sine of half the angle from a vertical, whose double square is ``least + x^2``, and the ratio of x to its root: 1 through the vertical."""
    root = sqrt(least + x * x)
    off = least > 0
    return where(off, _signed(root, like), x) / sqrt(whole(2, root)), where(off, _signed(x, like) / where(off, root, 1), 1)
