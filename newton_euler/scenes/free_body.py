"""A body with three moments of inertia on which no moment acts, by its body rates: exact, and next to the separatrix too (8.14 with M = 0).

Along principal axes fixed in the body I_x w_x' = (I_y - I_z) w_y w_z and cyclic. The solution is Jacobi's: with a, c the axes of largest and least
moment in the order that the motion circles a, and b the intermediate one, w_a = A dn, w_b = B sn, w_c = C cn. Near the separatrix, the motions that
leave the intermediate axis and come back to it, k^2 is 1 within rounding, and formulas in k^2 are nonsense. Here 1 - k^2 comes from a difference
of two squares, in more digits where these cancel, and the functions from :mod:`newton_euler.elliptic`.
"""

from ..elliptic import first_kind, jacobi
from ..gyros import GyroError
from ..models import Model, ModelError
from ..scalars import is_finite, is_numeric, least, plain, size, sqrt, unrounded, where
from ..vectors import dot3

AXES = "xyz"


def free_body(I_x, I_y, I_z):
    """The free body as a Model: states w_x, w_y, w_z along its principal axes (rad/s); invariants ``energy`` and ``momentum``, the size of H.

    The numbers given are taken as exact, and the exact solution is right to a few round-offs of t times the rate of the motion, wherever it starts:
    beside the separatrix, on it, or at rest about an axis. t, and the states, may be arrays; expressions are refused in words.

    >>> body = free_body(1.0, 2.0, 3.0)
    >>> [round(w, 6) for w in body.solution(20.0, (1e-7, 1.0, 1e-7))]
    [-0.003787, 0.999993, 0.002187]
    """
    parameters = {"I_x": I_x, "I_y": I_y, "I_z": I_z}
    return Model("free body", parameters, ("w_x", "w_y", "w_z"), _rates, {"energy": _energy, "momentum": _momentum}, _exact)


def tilt_growth(I_x, I_y, I_z, axis, rate):
    """The rate (1/s) at which a small tilt grows while a body spins at ``rate`` about its principal ``axis`` "x", "y" or "z": 0 where it does not.

    For the axis n with the others u, v it is |rate| sqrt((I_n - I_u)(I_v - I_n)/(I_u I_v)), real about the intermediate one alone. In the time T a
    tilt grows by exp(growth T). A run of floats that starts on the axis stays there, and says nothing.

    >>> tilt_growth(1.0, 2.0, 3.0, "z", 10.0), round(tilt_growth(1.0, 2.0, 3.0, "y", 3.0), 6)
    (0.0, 1.732051)
    """
    if axis not in AXES:
        raise GyroError(f"the axis is 'x', 'y' or 'z', got {axis!r}")
    n = AXES.index(axis)
    I = [plain(x) for x in (I_x, I_y, I_z)]
    own, u, v = I[n], I[(n + 1) % 3], I[(n + 2) % 3]
    square = (own - u) * (v - own) / (u * v)
    return abs(rate) * sqrt(where(square > 0, square, abs(0.0 * square)))


def _w(s):
    return s.w_x, s.w_y, s.w_z


def _rates(s, p, t):
    return (
        (p.I_y - p.I_z) * (s.w_y * s.w_z) / p.I_x,
        (p.I_z - p.I_x) * (s.w_z * s.w_x) / p.I_y,
        (p.I_x - p.I_y) * (s.w_x * s.w_y) / p.I_z,
    )


def _energy(s, p, t):
    return (p.I_x * s.w_x**2 + p.I_y * s.w_y**2 + p.I_z * s.w_z**2) / 2


def _momentum(s, p, t):
    H = p.I_x * s.w_x, p.I_y * s.w_y, p.I_z * s.w_z
    return sqrt(dot3(H, H))


# -- the exact solution


def _exact(s, p, t):
    moments, w = [plain(x) for x in (p.I_x, p.I_y, p.I_z)], [plain(x) for x in _w(s)]
    _check(moments, w, plain(t))
    like = 0.0 * (sum(w) + plain(t))
    w = [x + like for x in w]
    c, b, a = order = sorted(range(3), key=moments.__getitem__)
    parity = 1 if order in ([0, 1, 2], [1, 2, 0], [2, 0, 1]) else -1  # of c, b, a; a, b, c has the other one
    found = _circling(*(moments[n] for n in (a, b, c)), *(w[n] for n in (a, b, c)), t, parity)
    return tuple(x for _, x in sorted(zip((a, b, c), found, strict=True), key=lambda pair: pair[0]))


def _check(moments, w, t):
    if not all(map(is_numeric, (*moments, *w, t))):
        raise ModelError("the exact solution of the free body needs numbers: its branches compare the moments and the state; put values in first")
    if not all(map(is_finite, (*moments, *w, t))):
        raise ModelError(f"the free body cannot start with {w} at moments {moments} and go to t = {t}: all must be finite")
    if any(getattr(x, "shape", ()) for x in moments) or not least(min(moments)) > 0 or not min(moments) > 0:
        raise ModelError(f"the principal moments of the exact solution are three positive numbers, got {moments}; solve arrays of bodies one by one")


def _circling(Ia, Ib, Ic, wa, wb, wc, t, parity):
    """The rates about the axes of largest, intermediate and least moment at the time t; a and c change places where the motion circles c."""
    D = _side(Ia, Ib, Ic, wa, wc)
    about_c = D < 0
    (Ia, wa), (Ic, wc) = [
        (where(about_c, I2, I1), where(about_c, w2, w1)) for I1, w1, I2, w2 in ((Ia, wa, Ic, wc), (Ic, wc, Ia, wa))
    ]  # fmt: skip
    N = (Ic * (Ia - Ic)) * (wc * wc) + (Ib * (Ia - Ib)) * (wb * wb)  # 2 T I_a - H^2
    Q = (Ib * (Ib - Ic)) * (wb * wb) + (Ia * (Ia - Ic)) * (wa * wa)  # H^2 - 2 T I_c
    rests = N * Q * (Ia - Ib) * (abs(wa) + abs(wc)) == 0  # turns steadily: about an axis, or because moments are equal
    safe = [where(rests, 1, x) for x in (N, Q, Ia - Ic, Ia - Ib)]
    N, Q, wide, narrow = safe
    A, C = _like_sign(sqrt(Q / (Ia * wide)), wa), _like_sign(sqrt(N / (Ic * wide)), wc)
    B = _like_sign(sqrt(N / (Ib * narrow)), parity * A * C)
    rate, m1 = sqrt(narrow * Q / (Ia * Ib * Ic)), where(rests, 1, wide * D / (narrow * Q))
    m1 = where(m1 > 1, 1, m1)
    start = first_kind(where(rests, 0, wb / B), where(rests, 1, wc / C), m1)
    sn, cn, dn = jacobi(rate * t + start, m1)
    a, b, c = (where(rests, w, x) for w, x in ((wa, A * dn), (wb, B * sn), (wc, C * cn)))
    return where(about_c, c, a), b, where(about_c, a, c)


def _side(Ia, Ib, Ic, wa, wc):
    """H^2 - 2 T I_b: positive where the motion circles the axis of the largest moment, 0 on the separatrix."""

    def side(Ia, Ib, Ic, wa, wc):
        return Ia * (Ia - Ib) * wa**2 - Ic * (Ib - Ic) * wc**2

    scale = Ia * (Ia - Ib) * wa**2 + Ic * (Ib - Ic) * wc**2
    D = side(Ia, Ib, Ic, wa, wc)
    cancelled = abs(D) < scale / 16
    return unrounded(side, Ia, Ib, Ic, wa, wc) if size(where(cancelled, 1, 0)) else D


def _like_sign(x, sign):
    return where(sign < 0, -x, x)
