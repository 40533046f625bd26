"""Rates with kinks and jumps.

Friction, drag as it is usually written, springs with play, walls, valves.
"""

import math

from newton_euler import cos, sin, sqrt, where
from tests.honesty.cases import Log, by_accelerations, by_rates, family

DRIVE = {"k": (0.5, 20.0), "c": (0.05, 0.5), "F": (0.5, 3.0), "w": Log(0.2, 8.0)}  # an oscillator


@family("kinked")
def drag_by_abs(rng):
    """A body thrown upwards against air drag v |v|, until after it has turned back."""
    rates = lambda s, p, t: (s.v, -p.g - p.c * abs(s.v) * s.v)
    parameters = rng.parameters(g=9.81, c=Log(1e-3, 0.3))
    T, *start = rng.values((2.0, 8.0), (0.0, 10.0), (5.0, 40.0))
    return by_rates(rates, parameters, "h v", T, start)


@family("kinked")
def drag_by_root(rng):
    """A swing in water, its drag written as sqrt(v v) v, which is v |v|."""
    parameters = rng.parameters(k=Log(0.1, 30.0), c=Log(1e-2, 1.0))
    a = lambda s, p, t: (-p.k * s.x - p.c * sqrt(s.dx * s.dx) * s.dx,)
    T, x = rng.uniform(10.0, 60.0) / parameters["k"] ** 0.5, rng.either(rng.uniform(0.5, 3.0))
    return by_accelerations(a, parameters, "x", T, (x, 0.0))


@family("kinked")
def dry_friction(rng):
    """A mass on a spring and a rough floor, for some swings before it sticks."""
    k, mu, swings = rng.decades(0.3, 30.0), rng.decades(1e-2, 3.0), rng.randint(2, 12)
    start = mu / k * (2 * swings + 1 + rng.uniform(0.3, 1.7))
    a = lambda s, p, t: (-p.k * s.x - where(s.dx > 0, p.mu, -p.mu),)
    T = (swings - rng.uniform(0.1, 0.9)) * math.pi / k**0.5
    return by_accelerations(a, {"k": k, "mu": mu}, "x", T, (start, 0.0))


@family("kinked", "sticking")
def friction_to_rest(rng):
    """A block that slides until it stops, and then stays."""
    mu, v = rng.values(Log(0.1, 10.0), (1.0, 10.0))
    rates = lambda s, p, t: (s.v, where(s.v > 0, -p.mu, where(s.v < 0, p.mu, 0.0)))

    def exact(mp, s, p, t):
        t = min(t, s.v / p.mu)
        return s.x + s.v * t - p.mu * t * t / 2, s.v - p.mu * t

    return by_rates(rates, {"mu": mu}, "x v", rng.uniform(1.1, 3.0) * v / mu, (0.0, v), exact=exact)


@family("kinked")
def spring_with_play(rng):
    """A mass that is free between -d and d; beyond, a stiff spring holds it."""

    def accelerations(s, p, t):
        beyond = where(s.x > p.d, s.x - p.d, 0.0) + where(s.x < -p.d, s.x + p.d, 0.0)
        return (-p.k * beyond - p.c * s.dx,)

    parameters = rng.parameters(k=Log(1.0, 1e3), d=(0.1, 1.0), c=(0.0, 0.1))
    T, x, v = rng.values((3.0, 20.0), (-0.05, 0.05), (0.5, 3.0))
    return by_accelerations(accelerations, parameters, "x", T, (x, rng.either(v)))


@family("kinked")
def ball_on_an_elastic_floor(rng):
    """A ball that falls, is pushed back while it is in the floor, and bounces for ever."""
    rates = lambda s, p, t: (s.v, where(s.h < 0, -p.k * s.h, 0.0) - p.g)
    parameters = rng.parameters(g=9.81, k=Log(1e2, 1e6))
    T, *start = rng.values((1.0, 6.0), (0.3, 2.0), 0.0)
    return by_rates(rates, parameters, "h v", T, start)


@family("kinked")
def two_stiffnesses(rng):
    """A spring that is harder in compression than in extension."""
    a = lambda s, p, t: (-where(s.x > 0, p.soft, p.hard) * s.x,)
    parameters = rng.parameters(soft=Log(0.1, 10.0), hard=Log(1.0, 1e3))
    T, *start = rng.values((5.0, 40.0), (-1.0, 1.0), (-1.0, 1.0))
    return by_accelerations(a, parameters, "x", T, start)


@family("kinked")
def tank_with_an_overflow(rng):
    """A tank with a pump that comes and goes, a hole, and a weir that it overflows when full."""

    parameters = rng.parameters(
        q=(0.5, 1.5), c=(0.2, 0.6), weir=(2.0, 6.0), H=(0.9, 1.3), w=(0.5, 2.0), one=1.0
    )

    def rates(s, p, t):
        filled = p.q * (p.one + sin(p.w * t)) - p.c * sqrt(s.h)
        return (filled - where(s.h > p.H, p.weir * (s.h - p.H), 0.0),)

    T, h = rng.values((5.0, 30.0), (0.3, 1.5))
    return by_rates(rates, parameters, "h", T, (h,))


@family("kinked", "sticking")
def tank_that_runs_empty(rng):
    """A tank, h' = -c sqrt(h), that stays empty; its formula goes on as a parabola and fills it."""
    c, h = rng.values(Log(0.01, 10.0), Log(0.1, 10.0))

    def exact(mp, s, p, t):
        return (max(mp.sqrt(s.h) - p.c * t / 2, mp.mpf(0)) ** 2,)

    T = rng.choice((0.5, 0.9, 1.3, 2.0)) * 2 * h**0.5 / c
    return by_rates(lambda s, p, t: (-p.c * sqrt(s.h),), {"c": c}, "h", T, (h,), exact=exact)


@family("kinked")
def tank_nearly_empty(rng):
    """A tank with a small steady inflow falls to a level far below the first and stays there."""
    parameters = rng.parameters(c=1.0, q=Log(1e-3, 1e-1))
    T, start = rng.uniform(1.5, 6.0), (rng.uniform(0.5, 2.0),)
    return by_rates(lambda s, p, t: (p.q - p.c * sqrt(s.h),), parameters, "h", T, start)


@family("kinked")
def limited_control(rng):
    """A servo whose force has a limit: full force at first, then a spring."""

    def limited(s, p, t):
        u = -p.k * s.x - p.c * s.dx
        return (where(u > p.F, p.F, where(u < -p.F, -p.F, u)),)

    parameters = rng.parameters(F=(0.5, 2.0), k=(2.0, 10.0), c=(1.0, 4.0))
    T, x = rng.values((3.0, 12.0), (1.0, 5.0))
    start = rng.either(x), rng.uniform(-1.0, 1.0)
    return by_accelerations(limited, parameters, "x", T, start)


def _driven(rng, force):
    """An oscillator pushed by ``force``, which has kinks or jumps in time."""
    a = lambda s, p, t: (force(p, t) - p.k * s.x - p.c * s.dx,)
    parameters = rng.parameters(**DRIVE)
    T, *start = rng.values((5.0, 25.0), (-1.0, 1.0), (-1.0, 1.0))
    return by_accelerations(a, parameters, "x", T, start)


@family("kinked", "forced")
def rectified_drive(rng):
    """An oscillator pushed by |sin(w t)|: kinks in time."""
    force = lambda p, t: p.F * abs(sin(p.w * t))
    return _driven(rng, force)


@family("kinked", "forced")
def square_wave(rng):
    """An oscillator pushed to and fro by a constant force: jumps in time."""
    force = lambda p, t: where(cos(p.w * t) > 0, p.F, -p.F)
    return _driven(rng, force)


@family("kinked")
def friction_between_two(rng):
    """Two masses on springs that rub on each other; the lower is driven to keep them slipping."""
    parameters = rng.parameters(k=(1.0, 4.0), K=(20.0, 60.0), mu=(0.02, 0.2))

    def accelerations(s, p, t):
        rub = where(s.dx > s.dy, p.mu, -p.mu)
        return -p.k * s.x - rub, -p.K * s.y + rub

    T, y = rng.values((2.0, 8.0), (0.8, 1.5))
    return by_accelerations(accelerations, parameters, "x y", T, (1.0, y, 0.0, 0.0))


@family("kinked", "mechanics")
def string_that_goes_slack(rng):
    """A bob on an elastic string in a plane, thrown so high that the string hangs through."""
    parameters = rng.parameters(g=9.81, L=(0.8, 1.5), k=Log(50.0, 2000.0), c=(0.0, 0.05))

    def accelerations(s, p, t):
        taut = where(s.x * s.x + s.y * s.y - p.L * p.L > 0, 1.0, 0.0)
        r = sqrt(s.x * s.x + s.y * s.y)
        pull = taut * p.k * (r - p.L) / r
        return -pull * s.x - p.c * s.dx, -pull * s.y - p.c * s.dy - p.g

    T, angle, part = rng.values((1.5, 3.0), (1.7, 2.6), (0.9, 1.0))
    l = part * parameters["L"]
    start = l * math.sin(angle), -l * math.cos(angle), 0.3, 0.0
    return by_accelerations(accelerations, parameters, "x y", T, start)


@family("kinked", "mechanics")
def thruster_with_a_dead_band(rng):
    """A satellite under a steady torque, turned back by jets beyond two angles, with some lead."""
    parameters = rng.parameters(U=(0.5, 2.0), d=(0.1, 0.4), K=(0.01, 0.1), M=(0.02, 0.1))

    def a(s, p, t):
        led = s.x + p.K * s.dx
        return (p.M - where(led - p.d > 0, p.U, 0.0) + where(led + p.d > 0, 0.0, p.U),)

    T, x, v = rng.values((8.0, 15.0), (0.5, 2.0), (-1.0, 1.0))
    return by_accelerations(a, parameters, "x", T, (x, v))


@family("kinked", "forced")
def friction_of_two_thresholds(rng):
    """A driven mass whose friction rises with its speed up to one speed, and drops at another."""
    parameters = rng.parameters(k=(1.0, 10.0), F=(2.0, 6.0), w=(0.7, 3.0), m=(0.2, 1.0))
    parameters |= {"n": -parameters["m"] * rng.uniform(0.2, 0.8), "u": rng.uniform(0.05, 0.3)}
    parameters["U"] = parameters["u"] * rng.uniform(3.0, 6.0)

    def accelerations(s, p, t):
        b = [where(s.dx - speed > 0, 1.0, -1.0) for speed in (p.u, -p.u, p.U, -p.U)]
        slow = (b[1] - b[0]) / 2  # 1 between -u and u
        friction = p.m * ((b[0] + b[1]) / 2 + slow * s.dx / p.u) + p.n * (b[2] + b[3]) / 2
        return (p.F * sin(p.w * t) - p.k * s.x - friction,)

    T, x, v = rng.values((6.0, 20.0), (-1.0, 1.0), (0.5, 2.0))
    return by_accelerations(accelerations, parameters, "x", T, (x, v))
