"""Motions that are small beside their distance from the origin."""

import math

from newton_euler import cos, sqrt, where
from tests.honesty import closed_forms
from tests.honesty.cases import Log, by_accelerations, by_rates, family

EARTH = 3.986004418e14  # G M, m^3/s^2


@family("multi-scale", "far")
def far_spring(rng):
    """A spring about a point far from the origin."""
    w, X0, A = rng.values((0.5, 30.0), Log(1e3, 1e9), Log(1e-3, 1e-1))
    parameters = {"k": w * w, "X0": X0, "c": rng.choice((0.0, 0.02 * w))}
    a = lambda s, p, t: (-p.k * (s.x - p.X0) - 2 * p.c * s.dx,)

    def exact(mp, s, p, t):
        x, v = closed_forms.damped(mp, mp.sqrt(p.k), p.c, s.x - p.X0, s.dx, t)
        return p.X0 + x, v

    T = rng.uniform(5.0, 60.0) / w
    return by_accelerations(a, parameters, "x", T, (X0 + A, 0.0), exact=exact)


@family("multi-scale", "far")
def far_pair(rng):
    """Two masses joined by a spring, travelling far from the origin."""
    w, X, L, A, V = rng.values(
        (0.5, 10.0), Log(1e3, 1e9), (1.0, 50.0), Log(1e-3, 1e-1), (-1.0, 1.0)
    )
    parameters = {"k": w * w / 2, "L": L}

    def accelerations(s, p, t):
        pull = p.k * (s.y - s.x - p.L)
        return pull, -pull

    def exact(mp, s, p, t):
        n, half = mp.sqrt(2 * p.k), mp.mpf(1) / 2
        d, u = closed_forms.oscillator(mp, n, s.y - s.x - p.L, s.dy - s.dx, t)
        c, v = (s.x + s.y) * half + (s.dx + s.dy) * half * t, (s.dx + s.dy) * half
        return c - (p.L + d) * half, c + (p.L + d) * half, v - u * half, v + u * half

    T = rng.uniform(5.0, 60.0) / w
    return by_accelerations(accelerations, parameters, "x y", T, (X, X + L + A, V, V), exact=exact)


@family("multi-scale", "far", "mechanics")
def tethered_satellites(rng):
    """Two satellites on a tether of 50 to 500 m, which is stretched by millimetres."""
    r, L, n = rng.values((6.7e6, 8e6), (50.0, 500.0), (0.05, 0.5))
    parameters = {"GM": EARTH, "k": n * n / 2, "L": L}

    def rates(s, p, t):
        def weight(x, y):
            r2 = x * x + y * y
            return p.GM / (r2 * sqrt(r2))

        dx, dy, g, h = s.x2 - s.x1, s.y2 - s.y1, weight(s.x1, s.y1), weight(s.x2, s.y2)
        length = sqrt(dx * dx + dy * dy)
        pull = p.k * (length - p.L) / length
        first = -g * s.x1 + pull * dx, -g * s.y1 + pull * dy
        return s.u1, s.v1, s.u2, s.v2, *first, -h * s.x2 - pull * dx, -h * s.y2 - pull * dy

    far, v = r + L * (1 + rng.uniform(1e-6, 1e-4)), math.sqrt(EARTH / r**3) * r
    start = r, 0.0, far, 0.0, 0.0, v, 0.0, v / r * far
    return by_rates(rates, parameters, "x1 y1 x2 y2 u1 v1 u2 v2", 20.0 / n, start)


@family("multi-scale", "far", "kinked")
def layer_far_from_zero(rng):
    """A fall onto a layer with a hard edge, which pushes up, in coordinates of the Earth."""
    g, h, place, n = rng.values((5.0, 15.0), (0.5, 5.0), Log(1e3, 1e7), (2.0, 12.0))
    parameters = {"g": g, "place": place, "push": g * rng.uniform(1.5, 5.0)}
    rates = lambda s, p, t: (s.v, where(s.x < p.place, p.push, 0.0) - p.g)

    def exact(mp, s, p, t):
        fall, up = mp.sqrt(2 * (s.x - p.place) / p.g), p.push - p.g
        u = p.g * fall
        inside = 2 * u / up
        t = (t + fall) % (2 * fall + inside)  # since it left the layer
        if t > 2 * fall:
            t -= 2 * fall
            return p.place - u * t + up * t * t / 2, up * t - u
        return p.place + u * t - p.g * t * t / 2, u - p.g * t

    T = n * math.sqrt(2 * h / g)
    return by_rates(rates, parameters, "x v", T, (place + h, 0.0), exact=exact)


@family("multi-scale", "far", "tiny", "forced")
def shaken_by_a_clock_of_states(rng):
    """A swing of micrometres or millimetres far from zero, by a clock whose rate names a state."""
    w, q, place, f = rng.values((0.5, 5.0), (0.5, 5.0), Log(1e3, 1e7), Log(1e-6, 1e-2))
    way, part = rng.choice((-1.0, 1.0)), rng.choice((1.0, 1.7))
    parameters = {"k": w * w, "q": q / part, "place": place, "f": f, "rate": way * part}

    def rates(s, p, t):
        pull = p.f * cos(p.q * s.clock) - p.k * (s.x - p.place)
        return s.v, pull, p.rate + 0.0 * s.x

    def exact(mp, s, p, t):
        of = mp.sqrt(p.k), p.f, p.q * p.rate, s.x - p.place, s.v, t
        x, v = closed_forms.driven(mp, *of)
        return p.place + x, v, p.rate * t

    T = rng.uniform(3.0, 30.0)
    return by_rates(rates, parameters, "x v clock", T, (place, 0.0, 0.0), exact=exact)
