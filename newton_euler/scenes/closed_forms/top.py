"""The exact solution of the nutation of a symmetric top (10.24), by elliptic functions.

With v = 1 - cos(theta) the energy gives I0 v'^2/2 = F(v), a cubic with the roots v1, v2 and
-zeta/mgr. The roots of v - v1, v2 - v and zeta + mgr v change at rates that are products of the two
others. A top that is pulled up is one that is pulled down, seen from below.
"""

from ...algebra.portable import Values
from ...algebra.scalars import Scalar, cos, integer_like, sin, sqrt, where
from ...motion.model import comparable
from .elliptic import coupled, unwrapped


def nutation_exact(s: Values, p: Values, t: Scalar) -> tuple[Scalar, Scalar]:
    """theta and theta_rate of :func:`newton_euler.scenes.spatial.top.nutation` at t after ``s``."""
    # here: only the exact solution needs this room, which takes 30 ms to load
    from ...applications.nutation import exchanged

    given = s.theta, s.theta_rate, p.I0, p.I, p.mgr, p.omega_z, p.momentum_difference, t
    theta, rate, I0, I, mgr, omega_z, q, t = comparable("top", *given)
    whole, below, start = 2 * (I * omega_z) + q, mgr < 0, (cos(theta / 2), sin(theta / 2))
    (S, C), sides = exchanged(below, start[1], start[0]), exchanged(below, q, whole)
    S1, C1, rate1, phase = _nutation(S, C, where(below, -rate, rate), I0, abs(mgr), *sides, t)
    sine, cosine = exchanged(below, S1, C1)
    phase = where(rate < 0, -phase, phase)
    return 2 * unwrapped(theta / 2, start, (cosine, sine), phase), where(below, -rate1, rate1)


def _nutation(S, C, rate, I0, mgr, q, whole, t):
    """sin and cos of theta/2, theta' and the mean phase (0 unless it turns over); mgr >= 0."""
    from ...applications.nutation import turning_points

    v = 2 * (S * S)
    rest = q * C / (2 * where(abs(q) > 0, S, 1))
    more = whole * S / (2 * where(abs(whole) > 0, C, 1))
    transverse = rest + more, rest - more
    (X, Y), (v1, w2), zeta = turning_points(S, C, rate, I0, mgr, (q, whole), transverse)
    k = 1 / sqrt(2 * I0)
    start = _signed(sqrt(X), S), _signed(sqrt(Y), C), _signed(sqrt(zeta + mgr * v), rate)
    x, y, z, phase = coupled((k, -k, k * mgr), start, -(zeta + mgr * v1) / (2 * I0), t)
    S1, slant = _off(v1, x, S)
    C1, slant2 = _off(w2, y, C)
    return S1, C1, 2 * k * z * (slant * slant2), where(v1 > 0, 0, where(w2 > 0, 0, phase))


def _signed(x, like):
    return where(like < 0, -x, x)


def _off(least, x, like):
    """sqrt((least + x^2)/2), and x over sqrt(least + x^2), which is 1 through the vertical."""
    root = sqrt(least + x * x)
    off = least > 0
    return where(off, _signed(root, like), x) / sqrt(integer_like(2, root)), where(
        off, _signed(x, like) / where(off, root, 1), 1
    )
