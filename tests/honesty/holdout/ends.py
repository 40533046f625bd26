"""Motions that end, that stop, or that pass closely by a pole."""

import math

from newton_euler import Model, asin, exp, log, sqrt, where
from newton_euler.motion import second_order
from tests.honesty.cases import Case, decades, held_out


def _root(rng):
    y = decades(rng, 0.1, 30.0)
    return Model("y' = -k/y", {"k": 1.0}, ("y",), lambda s, p, t: (-p.k / s.y,)), y, y * y / 2


@held_out("singular", "no answer")
def beyond_a_root(rng):
    """y' = -1/y beyond the instant at which y is zero."""
    model, y, end = _root(rng)
    return Case(model, end * rng.choice((1.0001, 1.2, 5.0)), (y,), singular_at=end)


@held_out("near-singular")
def up_to_a_root(rng):
    """The same, until shortly before."""
    model, y, end = _root(rng)
    return Case(
        model,
        end * (1 - decades(rng, 1e-6, 0.5)),
        (y,),
        exact=lambda mp, s, p, t: (mp.sqrt(s.y * s.y - 2 * p.k * t),),
    )


@held_out("singular", "no answer")
def off_the_range_of_an_arcsine(rng):
    """A crank that is asked for more than it reaches: asin of more than one."""
    parameters = {"v": decades(rng, 0.1, 10.0)}
    end = rng.uniform(0.4, 1.2) / parameters["v"]
    start = 1 - parameters["v"] * end
    return Case(
        Model("crank", parameters, ("x", "y"), lambda s, p, t: (p.v, asin(s.x))),
        end * rng.choice((1.001, 1.3, 3.0)),
        (start, 0.0),
        singular_at=end,
    )


@held_out("singular", "no answer")
def tank_with_a_pump(rng):
    """A tank with a hole and a pump that goes on when it is empty: the root has no value then."""
    parameters = {"c": rng.uniform(0.1, 1.0), "q": rng.uniform(0.05, 0.5)}
    h = rng.uniform(0.3, 2.0)
    c, q = parameters.values()
    end = 2 / c * (math.sqrt(h) - q / c * math.log(1 + c / q * math.sqrt(h)))
    return Case(
        Model("pumped tank", parameters, ("h",), lambda s, p, t: (-p.q - p.c * sqrt(s.h),)),
        end * rng.choice((1.01, 1.5)),
        (h,),
        singular_at=end,
    )


@held_out("singular", "no answer")
def growth_without_bound(rng):
    """Growth that explodes: a power, an exponential, x log(x)^2."""
    kind = rng.choice(("power", "exponential", "logarithm"))
    if kind == "power":
        y, n = decades(rng, 0.1, 10.0), rng.choice((1.5, 3.0))
        rates, end = (lambda s, p, t: (s.y**p.n,)), y ** (1 - n) / (n - 1)
    elif kind == "exponential":
        y, n = rng.uniform(-2.0, 2.0), 1.0
        rates, end = (lambda s, p, t: (p.n * exp(s.y),)), math.exp(-y)
    else:
        y, n = rng.uniform(1.5, 5.0), 1.0
        rates, end = (lambda s, p, t: (p.n * s.y * log(s.y) ** 2,)), 1 / math.log(y)
    return Case(
        Model(kind, {"n": n}, ("y",), rates),
        end * rng.choice((1.01, 1.4, 3.0)),
        (y,),
        singular_at=end,
    )


@held_out("near-singular")
def sharp_peak(rng):
    """y' = -2 (t - a) y^2: a peak 1/e^2 high and e wide, of which nothing tells before."""
    e, a = decades(rng, 1e-3, 0.3), rng.uniform(0.5, 1.5)

    def exact(mp, s, p, t):
        return (1 / (1 / s.y + (t - p.a) ** 2 - p.a**2),)

    model = Model("peak", {"a": a}, ("y",), lambda s, p, t: (-2 * (t - p.a) * s.y * s.y,))
    return Case(model, a * rng.uniform(0.9, 2.5), (1 / (a * a + e * e),), exact=exact)


def _bubble(rng):
    R = decades(rng, 1e-6, 1e-2)
    model = second_order(
        "bubble",
        {"P": 100.0},  # pressure over density
        ("R",),
        lambda s, p, t: (-(p.P + 1.5 * s.dR * s.dR) / s.R,),
    )
    collapse = 0.9146813565 * R / 10.0
    return model, R, collapse


@held_out("singular", "no answer", "units")
def beyond_the_collapse_of_a_bubble(rng):
    """Rayleigh's bubble in metres, for longer than it takes to collapse."""
    model, R, collapse = _bubble(rng)
    return Case(model, collapse * rng.choice((1.001, 1.5)), (R, 0.0), singular_at=collapse)


@held_out("near-singular", "units")
def collapsing_bubble(rng):
    """The same, until shortly before."""
    model, R, collapse = _bubble(rng)
    return Case(model, collapse * (1 - decades(rng, 1e-5, 0.3)), (R, 0.0))


@held_out("kinked", "sticking")
def braking_by_a_root(rng):
    """A sledge whose drag goes with the root of its speed, clamped by where at rest."""
    parameters = {"c": decades(rng, 0.1, 10.0)}

    def rates(s, p, t):
        return s.v, where(s.v > 0, -p.c * sqrt(where(s.v > 0, s.v, 0.0)), 0.0)

    def exact(mp, s, p, t):
        u = mp.sqrt(s.v)
        left = max(u - p.c * t / 2, mp.mpf(0))
        third = mp.mpf(2) / (3 * p.c)
        return s.x + third * (u**3 - left**3), left**2

    v = decades(rng, 0.5, 20.0)
    rests = 2 * math.sqrt(v) / parameters["c"]
    return Case(
        Model("sledge", parameters, ("x", "v"), rates),
        rests * rng.choice((0.6, 0.95, 1.2, 3.0)),
        (0.0, v),
        exact=exact,
    )


@held_out("kinked", "sticking")
def torricelli_with_a_clamp(rng):
    """A tank that runs empty, and what ran out of it; the root is clamped by where."""
    parameters = {"k": decades(rng, 1e-3, 1.0)}

    def rates(s, p, t):
        out = p.k * sqrt(where(s.h > 0, s.h, 0.0))
        return -out, out

    def exact(mp, s, p, t):
        left = max(mp.sqrt(s.h) - p.k * t / 2, mp.mpf(0)) ** 2
        return left, s.h - left + s.out

    h = decades(rng, 0.05, 5.0)
    return Case(
        Model("Torricelli", parameters, ("h", "out"), rates),
        2 * math.sqrt(h) / parameters["k"] * rng.choice((0.8, 0.999, 1.001, 2.0)),
        (h, 0.0),
        exact=exact,
    )


@held_out("near-singular")
def tank_filling_from_empty(rng):
    """A tank that is filled from empty; the root has an infinite slope at the start."""
    parameters = {"q": decades(rng, 0.01, 1.0), "c": decades(rng, 0.1, 1.0)}
    model = Model("filling", parameters, ("h",), lambda s, p, t: (p.q - p.c * sqrt(abs(s.h)),))
    q, c = parameters.values()

    def exact(mp, s, p, t):
        if t <= 0:
            return (mp.mpf(0),)
        # t = -2/c (r + q/c log(1 - c r/q)), r = sqrt(h)
        late = p.c * p.c * t / (2 * p.q)
        z = 1 + mp.lambertw(-mp.exp(-1 - late)).real
        return ((p.q / p.c * z) ** 2,)

    return Case(model, q / (c * c) * decades(rng, 0.1, 8.0), (0.0,), exact=exact)
