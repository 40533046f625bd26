"""Motions that end, that stop, or that pass closely by a pole."""

import math

from newton_euler import Model, asin, exp, log, sqrt, where
from newton_euler.motion import second_order
from tests.honesty.cases import Case, Log, by_rates, held_out


def _root(rng):
    y = rng.decades(0.1, 30.0)
    return Model("y' = -k/y", {"k": 1.0}, ("y",), lambda s, p, t: (-p.k / s.y,)), y, y * y / 2


@held_out("singular", "no answer")
def beyond_a_root(rng):
    """y' = -k/y beyond the instant at which y is zero."""
    model, y, end = _root(rng)
    return Case(model, end * rng.choice((1.0001, 1.2, 5.0)), (y,), singular_at=end)


@held_out("near-singular")
def up_to_a_root(rng):
    """y' = -k/y until shortly before y is zero."""
    model, y, end = _root(rng)
    exact = lambda mp, s, p, t: (mp.sqrt(s.y * s.y - 2 * p.k * t),)
    return Case(model, end * (1 - rng.decades(1e-6, 0.5)), (y,), exact=exact)


@held_out("singular", "no answer")
def off_the_range_of_an_arcsine(rng):
    """A crank that is asked for more than it reaches: asin of more than one."""
    v = rng.decades(0.1, 10.0)
    end = rng.uniform(0.4, 1.2) / v
    T, start = end * rng.choice((1.001, 1.3, 3.0)), (1 - v * end, 0.0)
    return by_rates(lambda s, p, t: (p.v, asin(s.x)), {"v": v}, "x y", T, start, singular_at=end)


@held_out("singular", "no answer")
def tank_with_a_pump(rng):
    """A tank with a hole and a pump that goes on when it is empty: the root has no value then."""
    c, q, h = rng.values((0.1, 1.0), (0.05, 0.5), (0.3, 2.0))
    end = 2 / c * (math.sqrt(h) - q / c * math.log(1 + c / q * math.sqrt(h)))
    rates = lambda s, p, t: (-p.q - p.c * sqrt(s.h),)
    T = end * rng.choice((1.01, 1.5))
    return by_rates(rates, {"c": c, "q": q}, "h", T, (h,), singular_at=end)


@held_out("singular", "no answer")
def growth_without_bound(rng):
    """Growth that explodes: a power, an exponential, x log(x)^2."""
    kind = rng.choice(("power", "exponential", "logarithm"))
    if kind == "power":
        y, n = rng.decades(0.1, 10.0), rng.choice((1.5, 3.0))
        rates, end = (lambda s, p, t: (s.y**p.n,)), y ** (1 - n) / (n - 1)
    elif kind == "exponential":
        y, n = rng.uniform(-2.0, 2.0), 1.0
        rates, end = (lambda s, p, t: (p.n * exp(s.y),)), math.exp(-y)
    else:
        y, n = rng.uniform(1.5, 5.0), 1.0
        rates, end = (lambda s, p, t: (p.n * s.y * log(s.y) ** 2,)), 1 / math.log(y)
    return by_rates(rates, {"n": n}, "y", end * rng.choice((1.01, 1.4, 3.0)), (y,), singular_at=end)


@held_out("near-singular")
def sharp_peak(rng):
    """y' = -2 (t - a) y^2: a peak 1/e^2 high and e wide, which nothing announces."""
    e, a, T = rng.values(Log(1e-3, 0.3), (0.5, 1.5), (0.9, 2.5))
    exact = lambda mp, s, p, t: (1 / (1 / s.y + (t - p.a) ** 2 - p.a**2),)
    rates = lambda s, p, t: (-2 * (t - p.a) * s.y * s.y,)
    return by_rates(rates, {"a": a}, "y", a * T, (1 / (a * a + e * e),), exact=exact)


def _bubble(rng):
    R = rng.decades(1e-6, 1e-2)
    a = lambda s, p, t: (-(p.P + 1.5 * s.dR * s.dR) / s.R,)
    model = second_order("bubble", {"P": 100.0}, ("R",), a)  # P: pressure over density
    return model, R, 0.9146813565 * R / 10.0


@held_out("singular", "no answer", "units")
def beyond_the_collapse_of_a_bubble(rng):
    """Rayleigh's bubble in metres, for longer than it takes to collapse."""
    model, R, collapse = _bubble(rng)
    return Case(model, collapse * rng.choice((1.001, 1.5)), (R, 0.0), singular_at=collapse)


@held_out("near-singular", "units")
def collapsing_bubble(rng):
    """Rayleigh's bubble in metres, until shortly before it collapses."""
    model, R, collapse = _bubble(rng)
    return Case(model, collapse * (1 - rng.decades(1e-5, 0.3)), (R, 0.0))


@held_out("kinked", "sticking")
def braking_by_a_root(rng):
    """A sledge whose drag goes with the root of its speed, set to zero at rest by where."""
    c, v = rng.values(Log(0.1, 10.0), Log(0.5, 20.0))
    drag = lambda s, p: where(s.v > 0, -p.c * sqrt(where(s.v > 0, s.v, 0.0)), 0.0)
    rates = lambda s, p, t: (s.v, drag(s, p))

    def exact(mp, s, p, t):
        u = mp.sqrt(s.v)
        left = max(u - p.c * t / 2, mp.mpf(0))
        return s.x + mp.mpf(2) / (3 * p.c) * (u**3 - left**3), left**2

    T = 2 * math.sqrt(v) / c * rng.choice((0.6, 0.95, 1.2, 3.0))
    return by_rates(rates, {"c": c}, "x v", T, (0.0, v), exact=exact)


@held_out("kinked", "sticking")
def torricelli_with_a_clamp(rng):
    """A tank that runs empty, and what ran out of it; where keeps the root real."""
    k, h = rng.values(Log(1e-3, 1.0), Log(0.05, 5.0))

    def rates(s, p, t):
        out = p.k * sqrt(where(s.h > 0, s.h, 0.0))
        return -out, out

    def exact(mp, s, p, t):
        left = max(mp.sqrt(s.h) - p.k * t / 2, mp.mpf(0)) ** 2
        return left, s.h - left + s.out

    T = 2 * math.sqrt(h) / k * rng.choice((0.8, 0.999, 1.001, 2.0))
    return by_rates(rates, {"k": k}, "h out", T, (h, 0.0), exact=exact)


@held_out("near-singular")
def tank_filling_from_empty(rng):
    """A tank that is filled from empty; the root has an infinite slope at the start."""
    q, c = rng.values(Log(0.01, 1.0), Log(0.1, 1.0))
    rates = lambda s, p, t: (p.q - p.c * sqrt(abs(s.h)),)

    def exact(mp, s, p, t):
        if t <= 0:
            return (mp.mpf(0),)
        # t = -2/c (r + q/c log(1 - c r/q)), r = sqrt(h)
        late = p.c * p.c * t / (2 * p.q)
        z = 1 + mp.lambertw(-mp.exp(-1 - late)).real
        return ((p.q / p.c * z) ** 2,)

    T = q / (c * c) * rng.decades(0.1, 8.0)
    return by_rates(rates, {"q": q, "c": c}, "h", T, (0.0,), exact=exact)
