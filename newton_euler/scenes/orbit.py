"""A body on its orbit about a fixed centre of attraction, in the plane of the motion: Kepler's problem, exact for ellipse, parabola and hyperbola.

The exact solution uses the variable s with ds = dt/r (K. Stumpff's), in which time is a sum without small divisors even at a close approach:
t = r0 G1 + (r0 . v0) G2 + mu G3. Its slope is r > 0, so it has one root, found by Newton's steps between bounds that never let them escape.
"""

import math

from ..doubled import doubled
from ..models import Model, ModelError
from ..scalars import atan2, cos, cosh, epsilon, is_comparable, is_finite, is_numeric, least, plain, sin, sinh, size, sqrt, unrounded, where


def orbit(mu):
    """The orbit as a Model: states x, y, v_x, v_y; invariants ``energy`` and ``angular_momentum`` over mass, and the Laplace vector's two components.

    mu : the constant of the attraction mu/r^2, m^3/s^2. The Laplace vector has the size of the eccentricity and points to the closest approach.
    The exact solution takes the numbers given as exact. Its error in position is at most 4 round-offs of the size of the orbit plus the way that the
    body would run in the time t at its speed there (of 1500 random orbits). A hyperbola on its way in takes about 50 ms, for it needs more digits.
    Orbits through the centre, and expressions, are refused in words. Traced, as for :func:`newton_euler.motion.integrate`, it is for ellipses alone,
    and nan for other orbits, and fifty times as fast.

    >>> import math
    >>> [round(x, 9) for x in orbit(1.0).solution(math.pi/2, (1.0, 0.0, 0.0, 1.0))]
    [0.0, 1.0, -1.0, 0.0]
    """
    invariants = {"energy": _energy, "angular_momentum": _angular_momentum, "laplace_x": _laplace_x, "laplace_y": _laplace_y}
    return Model("Kepler's orbit", {"mu": mu}, ("x", "y", "v_x", "v_y"), _rates, invariants, _exact)


def from_farthest(mu, a, e):
    """The state (x, y, v_x, v_y) at the farthest point of the ellipse of semi-axis a and eccentricity e: at x = -a(1 + e).

    >>> from_farthest(1.0, 1.0, 0.0)
    (-1.0, 0.0, 0.0, -1.0)
    """
    return -a * (1 + e), 0 * a, 0 * a, -sqrt(mu * (1 - e) / (a * (1 + e)))


def _rates(s, p, t):
    r = _distance(s)
    pull = -p.mu / (r * r * r)
    return s.v_x, s.v_y, pull * s.x, pull * s.y


def _distance(s):
    return sqrt(s.x * s.x + s.y * s.y)


def _energy(s, p, t):
    return (s.v_x**2 + s.v_y**2) / 2 - p.mu / _distance(s)


def _angular_momentum(s, p, t):
    return s.x * s.v_y - s.y * s.v_x


def _laplace_x(s, p, t):
    return s.v_y * _angular_momentum(s, p, t) / p.mu - s.x / _distance(s)


def _laplace_y(s, p, t):
    return -(s.v_x * _angular_momentum(s, p, t)) / p.mu - s.y / _distance(s)


# -- the exact solution


def _exact(s, p, t):
    given = [plain(x) for x in (s.x, s.y, s.v_x, s.v_y, p.mu, t)]
    if not all(map(is_numeric, given)) and all(map(is_comparable, given)):
        return _ellipse(*given)  # it is being traced
    _check(*given)
    x, y, v_x, v_y, mu, t = [v + 0.0 * sum(given) for v in given]
    past = where(t < 0, -1, 1)
    v_x, v_y, t = past * v_x, past * v_y, abs(t)
    beta = _beta(x, y, v_x, v_y, mu)
    if size(where(beta < 0, where(x * v_x + y * v_y < 0, 1, 0), 0)):  # comes in from far away: exponentials cancel at the turn
        x, y, v_x, v_y = (unrounded(lambda *known, n=n: _moved(*known)[n], x, y, v_x, v_y, mu, t) for n in range(4))
    else:
        x, y, v_x, v_y = _moved(x, y, v_x, v_y, mu, t, beta)
    return x, y, past * v_x, past * v_y


def _moved(x, y, v_x, v_y, mu, t, beta=None):
    """The state at the time t >= 0 after this one."""
    beta = _beta(x, y, v_x, v_y, mu) if beta is None else beta
    r0, along = sqrt(x * x + y * y), x * v_x + y * v_y
    G, r = _anomaly(r0, along, beta, mu, t)
    f, g = 1 - mu * G[2] / r0, r0 * G[1] + along * G[2]
    df, dg = -mu * G[1] / (r0 * r), 1 - mu * G[2] / r
    return x * f + v_x * g, y * f + v_y * g, x * df + v_x * dg, y * df + v_y * dg


def _check(x, y, v_x, v_y, mu, t):
    if not all(map(is_numeric, (x, y, v_x, v_y, mu, t))):
        raise ModelError("Kepler's equation is solved for numbers, since it has no formula for its root; put values in first")
    if not all(map(is_finite, (x, y, v_x, v_y, mu, t))) or size(where(mu <= 0, 1, 0)):
        raise ModelError(f"an orbit needs finite numbers and a positive mu, got mu = {mu}, state {(x, y, v_x, v_y)}, t = {t}")
    swept = x * v_y - y * v_x
    if least(abs(swept) - 4 * epsilon(swept) * (abs(x * v_y) + abs(y * v_x))) == 0 or size(where(swept == 0, 1, 0)):
        raise ModelError("the orbit is a straight line through the centre (angular momentum 0), where the attraction has no bound")


def _beta(x, y, v_x, v_y, mu):
    """mu/a = 2 mu/r - v^2, in more digits where the two nearly cancel."""

    def beta(x, y, v_x, v_y, mu):
        return 2 * mu / sqrt(x * x + y * y) - v_x * v_x - v_y * v_y

    value = beta(x, y, v_x, v_y, mu)
    cancelled = abs(value) < (v_x * v_x + v_y * v_y) / 2
    return unrounded(beta, x, y, v_x, v_y, mu) if size(where(cancelled, 1, 0)) else value


def _anomaly(r0, along, beta, mu, t):
    """The functions G0 … G3 of the s that belongs to the time t >= 0, and the distance r there."""

    def reached(s):
        G = _stumpff(beta, s)
        return G, r0 * G[1] + along * G[2] + mu * G[3] - t, r0 * G[0] + along * G[1] + mu * G[2]

    low, unit = 0 * t, sqrt(1 / where(beta < 0, -beta, 1))
    high = where(beta * (t / r0) ** 2 < -1, unit, t / r0)  # an exponential of t/r0 might overflow
    while size(where(reached(high)[1] < 0, 1, 0)):
        high = where(reached(high)[1] < 0, 2 * high, high)
    s = high
    for _ in range(200):
        _, late, r = reached(s)
        low, high = where(late <= 0, s, low), where(late >= 0, s, high)
        step = s - late / where(r > 0, r, 1)
        inside = where(step >= low, where(step <= high, where(r > 0, 1, 0), 0), 0) == 1
        new = where(inside, step, (low + high) / 2)
        moved, s = abs(new - s), new
        if not size(where(moved > 2 * epsilon(s) * abs(s), 1, 0)):
            break
    G, _, r = reached(s)
    return G, r


def _stumpff(beta, s):
    """G_n = s^n (1/n! - z/(n+2)! + z^2/(n+4)! - …) with z = beta s^2, for n = 0 … 3; by circular and hyperbolic functions where z is not small."""
    z = beta * s * s
    bound, closed, open_ = where(abs(z) <= 1, z, 0), z > 1, z < -1
    G3, G2 = s**3 * _series(bound, 3), s**2 * _series(bound, 2)
    root = sqrt(where(closed, beta, where(open_, -beta, 1)))
    angle = root * s
    turned, grown = where(closed, angle, 1), where(open_, angle, 1)
    half, half_h, sine, sine_h = sin(turned / 2), sinh(grown / 2), sin(turned), sinh(grown)
    G2 = where(closed, 2 * half * half / root**2, where(open_, 2 * half_h * half_h / root**2, G2))
    G3 = where(closed, (turned - sine) / root**3, where(open_, (sine_h - grown) / root**3, G3))
    G1 = where(closed, sine / root, where(open_, sine_h / root, s - beta * G3))
    G0 = where(open_, cosh(grown), 1 - beta * G2)
    return G0, G1, G2, G3


def _series(z, n):
    term = 1 + 0 * z
    for k in range(2, n + 1):
        term = term / k
    total, k = 0 * z, n
    while size(term) > float(epsilon(z)) / 64:
        total = total + term
        term = -term * z / ((k + 1) * (k + 2))
        k += 2
    return total


# -- an ellipse in steps whose number is known beforehand, to be traced


def _ellipse(x, y, v_x, v_y, mu, t):
    """The state at t by the change u of the eccentric anomaly; nan if the orbit is no ellipse, or leads through the centre."""
    r0, along, swept = sqrt(x * x + y * y), x * v_x + y * v_y, x * v_y - y * v_x
    beta = _beta_traced(x, y, v_x, v_y, mu, r0)
    closed = beta * abs(swept) > 0
    beta = where(closed, beta, 1)
    root, near = sqrt(beta), r0 * beta / mu
    rise, depth = along * root / mu, 1 - near  # e sin(E) and e cos(E)
    e, E0 = sqrt(rise * rise + depth * depth), atan2(rise, depth)
    mean = _wrapped(beta * root / mu * t)
    E = _anomaly_near(_wrapped(E0 - rise + mean), e, swept * swept * beta / (mu * mu) / (1 + e))
    u = mean + _wrapped(E - E0 - mean)
    for _ in range(2):
        u = _halley(u, near, rise, mean)
    half, turned = sin(u / 2), cos(u / 2)
    G1, G2 = 2 * (half * turned) / root, 2 * (half * half) / beta
    r = r0 * (1 - beta * G2) + along * G1 + mu * G2
    f, g, df, dg = 1 - mu * G2 / r0, r0 * G1 + along * G2, -mu * G1 / (r0 * r), 1 - mu * G2 / r
    return tuple(where(closed, out, math.nan) for out in (x * f + v_x * g, y * f + v_y * g, x * df + v_x * dg, y * df + v_y * dg))


def _beta_traced(x, y, v_x, v_y, mu, r):
    """As :func:`_beta`, with what was rounded in the root r and in 2 mu/r."""
    pull, square = 2 * mu / r, v_x * v_x + v_y * v_y
    short = doubled(lambda x, y, r: x * x + y * y - r * r, x, y, r) / (2 * r)
    rest = (doubled(lambda mu, pull, r: mu + mu - pull * r, mu, pull, r) - pull * short) / r
    precise = doubled(lambda pull, v_x, v_y: pull - v_x * v_x - v_y * v_y, pull, v_x, v_y) + rest
    return where(abs(pull - square) < square / 4, precise, pull - square)


def _wrapped(angle):
    """The same angle between -pi and pi."""
    return atan2(sin(angle), cos(angle))


def _anomaly_near(M, e, rest):
    """The eccentric anomaly to about a thousandth from M between -pi and pi, e, and 1 - e (F. L. Markley, Celest. Mech. 63, 101, 1995)."""
    square = math.pi**2
    a = (3 * square + 1.6 * math.pi * (math.pi - abs(M)) / (1 + e)) / (square - 6)
    d = 3 * rest + a * e
    q, r = 2 * a * d * rest - M * M, abs(3 * a * d * (d - rest) * M + M * M * M)
    w = (r + sqrt(q * q * q + r * r)) ** (2 / 3)
    E = 2 * r * w / (w * w + w * q + q * q)
    return (where(M < 0, -E, E) + M) / d


def _halley(u, near, rise, mean):
    """One step of third order towards near sin(u) + rise (1 - cos(u)) + u - sin(u) = mean, in which nothing cancels."""
    half, turned = sin(u / 2), cos(u / 2)
    sine, drop = 2 * (half * turned), 2 * (half * half)
    late = near * sine + rise * drop + _less_sine(u, sine) - mean
    slope, bend = near + rise * sine + (1 - near) * drop, rise * (1 - drop) + (1 - near) * sine
    return u - 2 * late * slope / (2 * slope * slope - late * bend)


def _less_sine(u, sine):
    """u - sin(u)."""
    small = abs(u) < 1
    z = where(small, u * u, 0)
    series = 1 - z / 272
    for n in (210, 156, 110, 72, 42, 20):
        series = 1 - z / n * series
    return where(small, u * z / 6 * series, u - sine)
