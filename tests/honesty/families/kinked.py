"""Rates with kinks and jumps.

Friction, drag as it is usually written, springs with play, walls, valves.
"""

import math

from newton_euler import Model, cos, sin, sqrt
from newton_euler.motion import second_order
from tests.honesty.cases import Branches, Case, decades, either, family
from tests.honesty.engine import where


@family("kinked")
def drag_by_abs(rng):
    """Thrown upwards against the drag of the air, v |v|; it comes down again."""
    parameters = {"g": 9.81, "c": decades(rng, 1e-3, 0.3)}
    branches = Branches(
        (lambda s, p, t: s.v,), lambda s, p, t, b: (s.v, -p.g - p.c * b[0] * s.v * s.v)
    )
    model = Model(
        "throw", parameters, ("h", "v"), lambda s, p, t: (s.v, -p.g - p.c * abs(s.v) * s.v)
    )
    return Case(
        model,
        rng.uniform(2.0, 8.0),
        (rng.uniform(0.0, 10.0), rng.uniform(5.0, 40.0)),
        branches=branches,
    )


@family("kinked")
def drag_by_root(rng):
    """A swing in water: sqrt(v v) v, which is v |v| to whoever reads it."""
    parameters = {"k": decades(rng, 0.1, 30.0), "c": decades(rng, 1e-2, 1.0)}
    branches = Branches(
        (lambda s, p, t: s.dx,), lambda s, p, t, b: (s.dx, -p.k * s.x - p.c * b[0] * s.dx * s.dx)
    )
    model = second_order(
        "swing in water",
        parameters,
        ("x",),
        lambda s, p, t: (-p.k * s.x - p.c * sqrt(s.dx * s.dx) * s.dx,),
    )
    return Case(
        model,
        rng.uniform(10.0, 60.0) / parameters["k"] ** 0.5,
        (either(rng, rng.uniform(0.5, 3.0)), 0.0),
        branches=branches,
    )


@family("kinked")
def dry_friction(rng):
    """A mass on a spring and a rough floor, for some swings before it sticks."""
    k, mu, swings = decades(rng, 0.3, 30.0), decades(rng, 1e-2, 3.0), rng.randint(2, 12)
    start = mu / k * (2 * swings + 1 + rng.uniform(0.3, 1.7))
    model = second_order(
        "mass on a rough floor",
        {"k": k, "mu": mu},
        ("x",),
        lambda s, p, t: (-p.k * s.x - where(s.dx > 0, p.mu, -p.mu),),
    )
    branches = Branches(
        (lambda s, p, t: s.dx,), lambda s, p, t, b: (s.dx, -p.k * s.x - b[0] * p.mu)
    )
    return Case(
        model, (swings - rng.uniform(0.1, 0.9)) * math.pi / k**0.5, (start, 0.0), branches=branches
    )


@family("kinked", "sticking")
def friction_to_rest(rng):
    """A block that slides until it stops, and then stays."""
    model = Model(
        "sliding block",
        {"mu": decades(rng, 0.1, 10.0)},
        ("x", "v"),
        lambda s, p, t: (s.v, where(s.v > 0, -p.mu, where(s.v < 0, p.mu, 0.0))),
    )
    v = rng.uniform(1.0, 10.0)

    def exact(mp, s, p, t):
        t = min(t, s.v / p.mu)
        return s.x + s.v * t - p.mu * t * t / 2, s.v - p.mu * t

    return Case(model, rng.uniform(1.1, 3.0) * v / model.parameters["mu"], (0.0, v), exact=exact)


@family("kinked")
def spring_with_play(rng):
    """Nothing holds the mass between -d and d, a stiff spring beyond."""
    parameters = {
        "k": decades(rng, 1.0, 1e3),
        "d": rng.uniform(0.1, 1.0),
        "c": rng.uniform(0.0, 0.1),
    }

    def accelerations(s, p, t):
        return (
            -p.k * (where(s.x > p.d, s.x - p.d, 0.0) + where(s.x < -p.d, s.x + p.d, 0.0))
            - p.c * s.dx,
        )

    def pieces(s, p, t, b):
        return s.dx, -p.k * ((1 + b[0]) * (s.x - p.d) + (1 - b[1]) * (s.x + p.d)) / 2 - p.c * s.dx

    branches = Branches((lambda s, p, t: s.x - p.d, lambda s, p, t: s.x + p.d), pieces)
    model = second_order("spring with play", parameters, ("x",), accelerations)
    return Case(
        model,
        rng.uniform(3.0, 20.0),
        (rng.uniform(-0.05, 0.05), either(rng, rng.uniform(0.5, 3.0))),
        branches=branches,
    )


@family("kinked")
def ball_on_an_elastic_floor(rng):
    """It falls, is pushed back while it is in the floor, and bounces without end."""
    parameters = {"g": 9.81, "k": decades(rng, 1e2, 1e6)}
    model = Model(
        "ball on a floor",
        parameters,
        ("h", "v"),
        lambda s, p, t: (s.v, where(s.h < 0, -p.k * s.h, 0.0) - p.g),
    )
    branches = Branches(
        (lambda s, p, t: s.h,), lambda s, p, t, b: (s.v, -p.k * s.h * (1 - b[0]) / 2 - p.g)
    )
    return Case(model, rng.uniform(1.0, 6.0), (rng.uniform(0.3, 2.0), 0.0), branches=branches)


@family("kinked")
def two_stiffnesses(rng):
    """A spring that is harder in compression than in extension."""
    parameters = {"soft": decades(rng, 0.1, 10.0), "hard": decades(rng, 1.0, 1e3)}
    model = second_order(
        "two stiffnesses",
        parameters,
        ("x",),
        lambda s, p, t: (-where(s.x > 0, p.soft, p.hard) * s.x,),
    )
    branches = Branches(
        (lambda s, p, t: s.x,),
        lambda s, p, t, b: (s.dx, -(p.soft * (1 + b[0]) + p.hard * (1 - b[0])) * s.x / 2),
    )
    return Case(
        model,
        rng.uniform(5.0, 40.0),
        (rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)),
        branches=branches,
    )


@family("kinked")
def tank_with_an_overflow(rng):
    """Filled by a pump that comes and goes, emptied through a hole, and over a weir when it is
    full.
    """
    parameters = {
        "q": rng.uniform(0.5, 1.5),
        "c": rng.uniform(0.2, 0.6),
        "weir": rng.uniform(2.0, 6.0),
        "H": rng.uniform(0.9, 1.3),
        "w": rng.uniform(0.5, 2.0),
    }
    parameters["one"] = 1.0

    def rates(s, p, t):
        return (
            p.q * (p.one + sin(p.w * t))
            - p.c * sqrt(s.h)
            - where(s.h > p.H, p.weir * (s.h - p.H), 0.0),
        )

    def pieces(s, p, t, b):
        return (
            p.q * (p.one + sin(p.w * t)) - p.c * sqrt(s.h) - p.weir * (s.h - p.H) * (1 + b[0]) / 2,
        )

    model = Model("tank with an overflow", parameters, ("h",), rates)
    return Case(
        model,
        rng.uniform(5.0, 30.0),
        (rng.uniform(0.3, 1.5),),
        branches=Branches((lambda s, p, t: s.h - p.H,), pieces),
    )


@family("kinked", "sticking")
def tank_that_runs_empty(rng):
    """h' = -c sqrt(h).

    Empty after a finite time, and then it stays so; the formula goes on to a parabola that fills it
    again.
    """
    model = Model(
        "tank", {"c": decades(rng, 0.01, 10.0)}, ("h",), lambda s, p, t: (-p.c * sqrt(s.h),)
    )
    h = decades(rng, 0.1, 10.0)

    def exact(mp, s, p, t):
        return (max(mp.sqrt(s.h) - p.c * t / 2, mp.mpf(0)) ** 2,)

    return Case(
        model,
        rng.choice((0.5, 0.9, 1.3, 2.0)) * 2 * h**0.5 / model.parameters["c"],
        (h,),
        exact=exact,
    )


@family("kinked")
def tank_nearly_empty(rng):
    """The same with a small steady inflow.

    It comes down to a level far below the first and stays there.
    """
    model = Model(
        "tank with inflow",
        {"c": 1.0, "q": decades(rng, 1e-3, 1e-1)},
        ("h",),
        lambda s, p, t: (p.q - p.c * sqrt(s.h),),
    )
    return Case(model, rng.uniform(1.5, 6.0), (rng.uniform(0.5, 2.0),))


@family("kinked")
def limited_control(rng):
    """A servo whose force has a limit: full force at first, then a spring."""
    parameters = {
        "F": rng.uniform(0.5, 2.0),
        "k": rng.uniform(2.0, 10.0),
        "c": rng.uniform(1.0, 4.0),
    }

    def limited(s, p, t):
        u = -p.k * s.x - p.c * s.dx
        return (where(u > p.F, p.F, where(u < -p.F, -p.F, u)),)

    def pieces(s, p, t, b):
        u = -p.k * s.x - p.c * s.dx
        return s.dx, ((1 + b[0]) * p.F - (1 - b[1]) * p.F + (1 - b[0]) * (1 + b[1]) * u / 2) / 2

    switches = (
        lambda s, p, t: -p.k * s.x - p.c * s.dx - p.F,
        lambda s, p, t: -p.k * s.x - p.c * s.dx + p.F,
    )
    model = second_order("limited control", parameters, ("x",), limited)
    return Case(
        model,
        rng.uniform(3.0, 12.0),
        (either(rng, rng.uniform(1.0, 5.0)), rng.uniform(-1.0, 1.0)),
        branches=Branches(switches, pieces),
    )


@family("kinked", "forced")
def rectified_drive(rng):
    """An oscillator pushed by |sin(w t)|: kinks in time."""
    parameters = {
        "k": rng.uniform(0.5, 20.0),
        "c": rng.uniform(0.05, 0.5),
        "F": rng.uniform(0.5, 3.0),
        "w": decades(rng, 0.2, 8.0),
    }
    model = second_order(
        "rectified drive",
        parameters,
        ("x",),
        lambda s, p, t: (p.F * abs(sin(p.w * t)) - p.k * s.x - p.c * s.dx,),
    )
    branches = Branches(
        (lambda s, p, t: sin(p.w * t),),
        lambda s, p, t, b: (s.dx, p.F * b[0] * sin(p.w * t) - p.k * s.x - p.c * s.dx),
    )
    return Case(
        model,
        rng.uniform(5.0, 25.0),
        (rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)),
        branches=branches,
    )


@family("kinked", "forced")
def square_wave(rng):
    """An oscillator pushed to and fro by a constant force: jumps in time."""
    parameters = {
        "k": rng.uniform(0.5, 20.0),
        "c": rng.uniform(0.05, 0.5),
        "F": rng.uniform(0.5, 3.0),
        "w": decades(rng, 0.2, 8.0),
    }
    model = second_order(
        "square wave",
        parameters,
        ("x",),
        lambda s, p, t: (where(cos(p.w * t) > 0, p.F, -p.F) - p.k * s.x - p.c * s.dx,),
    )
    branches = Branches(
        (lambda s, p, t: cos(p.w * t),),
        lambda s, p, t, b: (s.dx, p.F * b[0] - p.k * s.x - p.c * s.dx),
    )
    return Case(
        model,
        rng.uniform(5.0, 25.0),
        (rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)),
        branches=branches,
    )


@family("kinked")
def friction_between_two(rng):
    """Two masses that rub on each other, tied to the wall by springs, while the lower one is driven
    hard enough to slip on.
    """
    parameters = {
        "k": rng.uniform(1.0, 4.0),
        "K": rng.uniform(20.0, 60.0),
        "mu": rng.uniform(0.02, 0.2),
    }

    def accelerations(s, p, t):
        rub = where(s.dx > s.dy, p.mu, -p.mu)
        return -p.k * s.x - rub, -p.K * s.y + rub

    def pieces(s, p, t, b):
        return s.dx, s.dy, -p.k * s.x - b[0] * p.mu, -p.K * s.y + b[0] * p.mu

    model = second_order("friction between two", parameters, ("x", "y"), accelerations)
    return Case(
        model,
        rng.uniform(2.0, 8.0),
        (1.0, rng.uniform(0.8, 1.5), 0.0, 0.0),
        branches=Branches((lambda s, p, t: s.dx - s.dy,), pieces),
    )
