"""Machines that cross thresholds: belts, diodes, weirs, gears, shadows, measured characteristics."""

import math
from itertools import pairwise

from newton_euler import Model, cos, sin, sqrt, table, where
from newton_euler.motion import second_order
from tests.honesty.cases import Branches, Case, Log, held_out


@held_out("kinked")
def seat_belt(rng):
    """A passenger slides in a braking car until the belt is taut; the belt yields at a limit."""
    parameters = rng.parameters(a=(30.0, 200.0), slack=(0.02, 0.1), k=(1e3, 5e3), F=(40.0, 300.0))
    parameters["c"] = rng.uniform(0.5, 5.0)

    def accelerations(s, p, t):
        pull = p.k * (s.x - p.slack)
        return (p.a - where(s.x > p.slack, where(pull > p.F, p.F, pull), 0.0) - p.c * s.dx,)

    def pieces(s, p, t, b):
        pull = (1 - b[1]) / 2 * p.k * (s.x - p.slack) + (1 + b[1]) / 2 * p.F
        return s.dx, p.a - (1 + b[0]) / 2 * pull - p.c * s.dx

    switches = lambda s, p, t: s.x - p.slack, lambda s, p, t: p.k * (s.x - p.slack) - p.F
    model = second_order("seat belt", parameters, ("x",), accelerations)
    branches = Branches(switches, pieces)
    return Case(model, rng.uniform(0.1, 0.5), (0.0, rng.uniform(0.0, 0.5)), branches=branches)


@held_out("kinked", "forced")
def diode_and_capacitor(rng):
    """A rectifier: the capacitor is charged while the mains are above it, and feeds a coil."""
    parameters = rng.parameters(V=(5.0, 20.0), w=(100.0, 400.0), Rd=(0.5, 5.0), C=Log(1e-4, 3e-3))
    parameters |= rng.parameters(R=(20.0, 200.0), L=(0.05, 1.0))

    def rates(s, p, t, charging):
        return charging / (p.Rd * p.C) - s.i / p.C, (s.u - p.R * s.i) / p.L

    over = lambda s, p, t: p.V * sin(p.w * t) - s.u
    model = Model("rectifier", parameters, ("u", "i"),
                  lambda s, p, t: rates(s, p, t, where(over(s, p, t) > 0, over(s, p, t), 0.0)))  # fmt: skip
    pieces = lambda s, p, t, b: rates(s, p, t, (1 + b[0]) / 2 * over(s, p, t))
    T = rng.uniform(3.0, 30.0) * 2 * math.pi / parameters["w"]
    return Case(model, T, (0.0, 0.0), branches=Branches((over,), pieces))


@held_out("kinked", "forced")
def lake_over_two_weirs(rng):
    """A flood into a lake that runs over one weir, and over a second one above it."""
    parameters = rng.parameters(q=(0.5, 2.0), w=(0.05, 0.3), low=(0.3, 0.8), c=(0.2, 1.0))
    parameters |= {"high": parameters["low"] + rng.uniform(0.2, 0.6), "d": rng.uniform(1.0, 5.0)}
    inflow = lambda p, t: p.q * sin(p.w * t) ** 2

    def rates(s, p, t):
        over, above = s.h - p.low, s.h - p.high
        first = where(over > 0, p.c * over * (1 + 0.3 * over), 0.0)
        return (inflow(p, t) - first - where(above > 0, p.d * above**2, 0.0),)

    def pieces(s, p, t, b):
        over, above = s.h - p.low, s.h - p.high
        first = (1 + b[0]) / 2 * p.c * over * (1 + 0.3 * over)
        return (inflow(p, t) - first - (1 + b[1]) / 2 * p.d * above**2,)

    switches = lambda s, p, t: s.h - p.low, lambda s, p, t: s.h - p.high
    model = Model("lake", parameters, ("h",), rates)
    T, h = rng.values((20.0, 150.0), (0.0, 0.3))
    return Case(model, T, (h,), branches=Branches(switches, pieces))


@held_out("kinked", "mechanics")
def ball_on_an_elastic_hill(rng):
    """A ball bounces over a soft hilly ground, which pushes it upwards and aside."""
    parameters = rng.parameters(g=9.81, k=Log(3e2, 3e4), H=(0.05, 0.3), q=(0.5, 2.0), c=(0.0, 0.5))
    height = lambda s, p: s.y - p.H * sin(p.q * s.x)

    def rates(s, p, push):
        slope = p.H * p.q * cos(p.q * s.x)
        return -push * slope - p.c * s.dx, push - p.g - p.c * s.dy

    a = lambda s, p, t: rates(s, p, where(height(s, p) < 0, -p.k * height(s, p), 0.0))
    pieces = lambda s, p, t, b: (
        s.dx, s.dy, *rates(s, p, -(1 - b[0]) / 2 * p.k * height(s, p)))  # fmt: skip
    model = second_order("hilly ground", parameters, ("x", "y"), a)
    T, y, v = rng.values((0.5, 3.0), (0.4, 1.5), (0.5, 3.0))
    branches = Branches((lambda s, p, t: height(s, p),), pieces)
    return Case(model, T, (0.0, y, v, 0.0), branches=branches)


class _Line:
    """A table that is linear between its points, and its pieces by signs at the inner ones."""

    def __init__(self, places, values):
        self.read, self.places, self.value = table(places, values), places, values[0]
        points = list(zip(places, values, strict=True))
        self.slopes = [(f - e) / (b - a) for (a, e), (b, f) in pairwise(points)]

    def pieces(self, x, b):
        """The value at x."""
        bends = zip(b, self.places[1:-1], pairwise(self.slopes), strict=False)
        more = sum((1 + sign) / 2 * (after - before) * (x - place)
                   for sign, place, (before, after) in bends)  # fmt: skip
        return self.value + self.slopes[0] * (x - self.places[0]) + more


@held_out("kinked", "forced")
def turbine_in_a_gust(rng):
    """A rotor in measured wind, linear in time, whose brake comes on above a speed."""
    T = rng.uniform(20.0, 120.0)
    places = sorted([0.0, 1.01 * T, *(rng.uniform(0.05, 0.95) * T for _ in range(8))])
    wind = _Line(places, [rng.uniform(4.0, 14.0) for _ in places])
    parameters = rng.parameters(J=(5.0, 50.0), c=(0.3, 1.0), d=(0.1, 0.5), B=(2.0, 20.0))
    parameters["top"] = rng.uniform(6.0, 14.0)
    over = lambda s, p: s.w - p.top
    law = lambda s, p, v, brake: ((p.c * v**2 - p.d * v * s.w - p.B * brake) / p.J,)
    rates = lambda s, p, t: law(s, p, wind.read(t), where(over(s, p) > 0, over(s, p), 0.0))
    pieces = lambda s, p, t, b: law(s, p, wind.pieces(t, b), (1 + b[-1]) / 2 * over(s, p))
    switches = *(lambda s, p, t, x=x: t - x for x in places[1:-1]), lambda s, p, t: over(s, p)
    model = Model("turbine", parameters, ("w",), rates)
    return Case(model, T, (rng.uniform(0.5, 5.0),), branches=Branches(switches, pieces))


@held_out("kinked", "long")
def satellite_through_a_shadow(rng):
    """A satellite pressed by light except where the planet hides the sun, revolution after
    revolution.
    """
    parameters = {"mu": 1.0, "R": rng.uniform(0.5, 0.9), "A": rng.decades(1e-4, 1e-2)}

    def rates(s, p, pressed):
        r3 = (s.x**2 + s.y**2) * sqrt(s.x**2 + s.y**2)
        return p.A * pressed - p.mu * s.x / r3, -p.mu * s.y / r3

    def accelerations(s, p, t):
        return rates(s, p, where(s.x > 0, where(abs(s.y) < p.R, 0.0, 1.0), 1.0))

    def pieces(s, p, t, b):
        shadow = (1 + b[0]) * (1 - b[1]) * (1 + b[2]) / 8
        return s.dx, s.dy, *rates(s, p, 1 - shadow)

    switches = lambda s, p, t: s.x, lambda s, p, t: s.y - p.R, lambda s, p, t: s.y + p.R
    model = second_order("satellite in light", parameters, ("x", "y"), accelerations)
    turns, v = rng.values((1.5, 4.0), (0.95, 1.1))
    start = -1.0, 0.0, 0.0, v
    return Case(model, turns * 2 * math.pi, start, branches=Branches(switches, pieces))


@held_out("kinked")
def car_with_three_gears(rng):
    """The force at the wheels jumps where the gear is changed, at two speeds."""
    parameters = rng.parameters(F=(3.0, 6.0), one=(4.0, 9.0), two=(14.0, 20.0), c=Log(1e-4, 1e-3))
    parameters |= rng.parameters(r=(0.05, 0.3), later=(0.5, 0.8), last=(0.3, 0.45))
    law = lambda s, p, force: (s.v, force - p.r - p.c * s.v * s.v)
    force = lambda s, p: p.F * where(s.v < p.one, 1.0, where(s.v < p.two, p.later, p.last))

    def pieces(s, p, t, b):
        up, top = (1 + b[0]) / 2, (1 + b[1]) / 2
        return law(s, p, p.F * (1 - up + up * (1 - top) * p.later + up * top * p.last))

    model = Model("gears", parameters, ("x", "v"), lambda s, p, t: law(s, p, force(s, p)))
    switches = lambda s, p, t: s.v - p.one, lambda s, p, t: s.v - p.two
    T, v = rng.values((3.0, 20.0), (0.0, 3.0))
    return Case(model, T, (0.0, v), branches=Branches(switches, pieces))


@held_out("kinked", "long")
def pendulum_clock(rng):
    """A pendulum with damping is pushed as it passes near the middle, for many swings."""
    n = rng.uniform(2.0, 8.0)
    parameters = {"k": n * n, "c": rng.uniform(0.01, 0.1) * n, "d": rng.uniform(0.02, 0.2)}
    parameters["F"] = n * n * rng.uniform(0.01, 0.1)
    law = lambda s, p, push: (-p.k * sin(s.theta) - p.c * s.dtheta + push,)

    def accelerations(s, p, t):
        near = where(abs(s.theta) < p.d, 1.0, 0.0)
        return law(s, p, near * where(s.dtheta > 0, p.F, -p.F))

    def pieces(s, p, t, b):
        return s.dtheta, *law(s, p, (1 - b[0]) * (1 + b[1]) / 4 * b[2] * p.F)

    switches = (lambda s, p, t: s.theta - p.d, lambda s, p, t: s.theta + p.d,
                lambda s, p, t: s.dtheta)  # fmt: skip
    model = second_order("pendulum clock", parameters, ("theta",), accelerations)
    T, theta = rng.values((3.0, 8.0), (0.3, 0.8))
    branches = Branches(switches, pieces)
    return Case(model, T * 2 * math.pi / n, (theta, 0.0), branches=branches)


@held_out("kinked")
def pump_with_a_characteristic(rng):
    """Water in a long pipe, by the measured head of a pump, linear between its points."""
    flows = [-100.0, rng.uniform(0.2, 0.5), rng.uniform(0.7, 1.0), rng.uniform(1.2, 1.5), 100.0]
    heads = [12.0, 12.5 + rng.uniform(0.2, 2.0), 11.5, 9.0, -2000.0]
    head = _Line(flows, heads)
    parameters = rng.parameters(L=(0.5, 5.0), k=(2.0, 8.0), A=(0.5, 3.0), z=(2.0, 6.0))
    law = lambda s, p, lift: ((lift - s.h - p.k * abs(s.q) * s.q) / p.L, (s.q - 0.3 * s.h) / p.A)

    def pieces(s, p, t, b):
        rest = (head.pieces(s.q, b) - s.h - p.k * b[-1] * s.q * s.q) / p.L
        return rest, (s.q - 0.3 * s.h) / p.A

    model = Model("pump", parameters, ("q", "h"), lambda s, p, t: law(s, p, head.read(s.q)))
    switches = *(lambda s, p, t, x=x: s.q - x for x in flows[1:-1]), lambda s, p, t: s.q
    T, h = rng.values((1.0, 10.0), (0.0, 4.0))
    return Case(model, T, (0.0, h), branches=Branches(switches, pieces))
