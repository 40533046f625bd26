"""Machines that cross thresholds: belts, diodes, weirs, gears, shadows, measured characteristics."""

import math

from newton_euler import cos, sin, sqrt, table, where
from tests.honesty.cases import Log, by_accelerations, by_rates, held_out


@held_out("kinked")
def seat_belt(rng):
    """A passenger slides in a braking car until the belt is taut; the belt yields at a limit."""
    parameters = rng.parameters(a=(30.0, 200.0), slack=(0.02, 0.1), k=(1e3, 5e3), F=(40.0, 300.0))
    parameters["c"] = rng.uniform(0.5, 5.0)

    def accelerations(s, p, t):
        pull = p.k * (s.x - p.slack)
        return (p.a - where(s.x > p.slack, where(pull > p.F, p.F, pull), 0.0) - p.c * s.dx,)

    T = rng.uniform(0.1, 0.5)
    return by_accelerations(accelerations, parameters, "x", T, (0.0, rng.uniform(0.0, 0.5)))


@held_out("kinked", "forced")
def diode_and_capacitor(rng):
    """A rectifier: the capacitor is charged while the mains are above it, and feeds a coil."""
    parameters = rng.parameters(V=(5.0, 20.0), w=(100.0, 400.0), Rd=(0.5, 5.0), C=Log(1e-4, 3e-3))
    parameters |= rng.parameters(R=(20.0, 200.0), L=(0.05, 1.0))

    def rates(s, p, t):
        over = p.V * sin(p.w * t) - s.u
        return where(over > 0, over, 0.0) / (p.Rd * p.C) - s.i / p.C, (s.u - p.R * s.i) / p.L

    T = rng.uniform(3.0, 30.0) * 2 * math.pi / parameters["w"]
    return by_rates(rates, parameters, "u i", T, (0.0, 0.0))


@held_out("kinked", "forced")
def lake_over_two_weirs(rng):
    """A flood into a lake that runs over one weir, and over a second one above it."""
    parameters = rng.parameters(q=(0.5, 2.0), w=(0.05, 0.3), low=(0.3, 0.8), c=(0.2, 1.0))
    parameters |= {"high": parameters["low"] + rng.uniform(0.2, 0.6), "d": rng.uniform(1.0, 5.0)}

    def rates(s, p, t):
        inflow, over, above = p.q * sin(p.w * t) ** 2, s.h - p.low, s.h - p.high
        first = where(over > 0, p.c * over * (1 + 0.3 * over), 0.0)
        return (inflow - first - where(above > 0, p.d * above**2, 0.0),)

    T, h = rng.values((20.0, 150.0), (0.0, 0.3))
    return by_rates(rates, parameters, "h", T, (h,))


@held_out("kinked", "mechanics")
def ball_on_an_elastic_hill(rng):
    """A ball bounces over a soft hilly ground, which pushes it upwards and aside."""
    parameters = rng.parameters(g=9.81, k=Log(3e2, 3e4), H=(0.05, 0.3), q=(0.5, 2.0), c=(0.0, 0.5))

    def accelerations(s, p, t):
        height = s.y - p.H * sin(p.q * s.x)
        push, slope = where(height < 0, -p.k * height, 0.0), p.H * p.q * cos(p.q * s.x)
        return -push * slope - p.c * s.dx, push - p.g - p.c * s.dy

    T, y, v = rng.values((0.5, 3.0), (0.4, 1.5), (0.5, 3.0))
    return by_accelerations(accelerations, parameters, "x y", T, (0.0, y, v, 0.0))


@held_out("kinked", "forced")
def turbine_in_a_gust(rng):
    """A rotor in measured wind, linear in time, whose brake comes on above a speed."""
    T = rng.uniform(20.0, 120.0)
    places = sorted([0.0, 1.01 * T, *(rng.uniform(0.05, 0.95) * T for _ in range(8))])
    wind = table(places, [rng.uniform(4.0, 14.0) for _ in places])
    parameters = rng.parameters(J=(5.0, 50.0), c=(0.3, 1.0), d=(0.1, 0.5), B=(2.0, 20.0))
    parameters["top"] = rng.uniform(6.0, 14.0)

    def rates(s, p, t):
        v, over = wind(t), s.w - p.top
        return ((p.c * v**2 - p.d * v * s.w - p.B * where(over > 0, over, 0.0)) / p.J,)

    return by_rates(rates, parameters, "w", T, (rng.uniform(0.5, 5.0),))


@held_out("kinked", "long")
def satellite_through_a_shadow(rng):
    """A satellite pressed by light except where the planet hides the sun, revolution after
    revolution.
    """
    parameters = {"mu": 1.0, "R": rng.uniform(0.5, 0.9), "A": rng.decades(1e-4, 1e-2)}

    def accelerations(s, p, t):
        pressed = where(s.x > 0, where(abs(s.y) < p.R, 0.0, 1.0), 1.0)
        r3 = (s.x**2 + s.y**2) * sqrt(s.x**2 + s.y**2)
        return p.A * pressed - p.mu * s.x / r3, -p.mu * s.y / r3

    turns, v = rng.values((1.5, 4.0), (0.95, 1.1))
    start = -1.0, 0.0, 0.0, v
    return by_accelerations(accelerations, parameters, "x y", turns * 2 * math.pi, start)


@held_out("kinked")
def car_with_three_gears(rng):
    """The force at the wheels jumps where the gear is changed, at two speeds."""
    parameters = rng.parameters(F=(3.0, 6.0), one=(4.0, 9.0), two=(14.0, 20.0), c=Log(1e-4, 1e-3))
    parameters |= rng.parameters(r=(0.05, 0.3), later=(0.5, 0.8), last=(0.3, 0.45))

    def rates(s, p, t):
        force = p.F * where(s.v < p.one, 1.0, where(s.v < p.two, p.later, p.last))
        return s.v, force - p.r - p.c * s.v * s.v

    T, v = rng.values((3.0, 20.0), (0.0, 3.0))
    return by_rates(rates, parameters, "x v", T, (0.0, v))


@held_out("kinked", "long")
def pendulum_clock(rng):
    """A pendulum with damping is pushed as it passes near the middle, for many swings."""
    n = rng.uniform(2.0, 8.0)
    parameters = {"k": n * n, "c": rng.uniform(0.01, 0.1) * n, "d": rng.uniform(0.02, 0.2)}
    parameters["F"] = n * n * rng.uniform(0.01, 0.1)

    def accelerations(s, p, t):
        near = where(abs(s.theta) < p.d, 1.0, 0.0)
        push = near * where(s.dtheta > 0, p.F, -p.F)
        return (-p.k * sin(s.theta) - p.c * s.dtheta + push,)

    T, theta = rng.values((3.0, 8.0), (0.3, 0.8))
    return by_accelerations(accelerations, parameters, "theta", T * 2 * math.pi / n, (theta, 0.0))


@held_out("kinked")
def pump_with_a_characteristic(rng):
    """Water in a long pipe, by the measured head of a pump, linear between its points."""
    flows = [-100.0, rng.uniform(0.2, 0.5), rng.uniform(0.7, 1.0), rng.uniform(1.2, 1.5), 100.0]
    heads = [12.0, 12.5 + rng.uniform(0.2, 2.0), 11.5, 9.0, -2000.0]
    head = table(flows, heads)
    parameters = rng.parameters(L=(0.5, 5.0), k=(2.0, 8.0), A=(0.5, 3.0), z=(2.0, 6.0))

    def rates(s, p, t):
        return (head(s.q) - s.h - p.k * abs(s.q) * s.q) / p.L, (s.q - 0.3 * s.h) / p.A

    T, h = rng.values((1.0, 10.0), (0.0, 4.0))
    return by_rates(rates, parameters, "q h", T, (0.0, h))
