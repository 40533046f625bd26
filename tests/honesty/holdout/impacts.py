"""Events of many kinds: impacts, resets, turning points, moving tables, round walls."""

import math

from newton_euler import Event, Model, cos, sin
from newton_euler.motion import second_order
from tests.honesty.cases import Case, Log, by_accelerations, held_out
from tests.honesty.models import by_power


@held_out("events")
def between_floor_and_ceiling(rng):
    """A ball thrown hard between a floor and a ceiling of different restitution."""
    parameters = rng.parameters(g=9.81, e=(0.85, 0.98), E=(0.9, 1.0), H=2.0)
    floor = lambda s, p, t: (model, (0.0, -p.e * s.v))
    ceiling = lambda s, p, t: (model, (p.H, -p.E * s.v))
    model = Model("ball in a box", parameters, ("h", "v"), lambda s, p, t: (s.v, -p.g))
    low = Event(lambda s, p, t: s.h, -1, then=floor, name="floor")
    high = Event(lambda s, p, t: s.h - p.H, 1, then=ceiling, name="ceiling")
    T, *start = rng.values((1.0, 4.0), (0.5, 1.5), (10.0, 20.0))
    return Case(model, T, tuple(start), events=(low, high))


@held_out("events", "chaotic")
def round_billiard(rng):
    """A ball in a round box in a weak field, reflected at the wall."""

    def reflected(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        out = 2 * (s.x * s.dx + s.y * s.dy) / r2
        return s.x, s.y, s.dx - out * s.x, s.dy - out * s.y

    then = lambda s, p, t: (model, reflected(s, p, t))
    g, a, T, x, y = rng.values((0.0, 0.5), (0.0, 6.28), (4.0, 15.0), (-0.5, 0.5), (-0.5, 0.5))
    model = second_order("billiard", {"g": g}, ("x", "y"), lambda s, p, t: (0 * s.x, -p.g))
    wall = Event(lambda s, p, t: s.x * s.x + s.y * s.y - 1, 1, then=then, name="wall")
    return Case(model, T, (x, y, math.cos(a), math.sin(a)), events=(wall,))


@held_out("events", "kinked")
def rocking_block(rng):
    """A block that rocks from corner to corner and loses some of its rate at each change."""
    parameters = rng.parameters(p2=(2.0, 8.0), a=(0.1, 0.4), e=0.9)
    rates = lambda s, p, t: (s.w, -p.p2 * sin(p.a * s.side - s.th), 0 * s.side)
    then = lambda s, p, t: (model, (0.0, p.e * s.w, -s.side))
    model = Model("rocking block", parameters, ("th", "w", "side"), rates)
    hit = Event(lambda s, p, t: s.th, then=then, name="impact")
    th, T = rng.values((0.3, 0.9), (1.0, 4.0))
    return Case(model, T, (parameters["a"] * th, 0.0, 1.0), events=(hit,))


@held_out("events")
def spiking_neuron(rng):
    """Integrate and fire: the voltage is reset at each spike, and a slow current adapts."""
    parameters = rng.parameters(I=(1.2, 3.0), tau=(5.0, 20.0), d=0.1)
    rates = lambda s, p, t: (p.I - s.v - s.a, -s.a / p.tau)
    then = lambda s, p, t: (model, (0.0, s.a + p.d))
    model = Model("neuron", parameters, ("v", "a"), rates)
    spike = Event(lambda s, p, t: s.v - 1, 1, then=then, name="spike")
    return Case(model, rng.uniform(5.0, 25.0), (0.0, 0.0), events=(spike,))


@held_out("events", "chaotic")
def ball_on_a_shaking_table(rng):
    """A ball on a table that moves up and down."""
    parameters = rng.parameters(g=9.81, A=(0.005, 0.02), W=(20.0, 40.0), e=(0.5, 0.9))

    def thrown(s, p, t):
        table = p.A * p.W * cos(p.W * t)
        return p.A * sin(p.W * t), -p.e * s.v + (1 + p.e) * table

    then = lambda s, p, t: (model, thrown(s, p, t))
    model = Model("shaking table", parameters, ("h", "v"), lambda s, p, t: (s.v, -p.g))
    hit = Event(lambda s, p, t: s.h - p.A * sin(p.W * t), -1, then=then, name="hit")
    T, h = rng.values((0.5, 1.5), (0.2, 0.6))
    return Case(model, T, (h, 0.0), events=(hit,))


@held_out("events", "kinked")
def turning_points(rng):
    """A swing with drag v |v|: when it passes the middle, and one level of its energy."""
    parameters = rng.parameters(k=(1.0, 30.0), c=(0.02, 0.5))
    a = lambda s, p, t: (-p.k * sin(s.x) - p.c * abs(s.dx) * s.dx,)
    middle = Event(lambda s, p, t: s.x, name="middle")
    level = Event(lambda s, p, t: s.dx * s.dx / 2 - p.k * cos(s.x), name="level")
    T, x = rng.values((3.0, 18.0), (0.5, 2.5))
    T /= parameters["k"] ** 0.5
    return by_accelerations(a, parameters, "x", T, (x, -0.1), events=(middle, level))


@held_out("events")
def pairs_of_passages(rng):
    """A probe that dips below a height over a planet, briefly or not at all: zeros in pairs."""
    e, gap = rng.values((0.1, 0.6), Log(1e-6, 1e-2))
    sign = rng.choice((1, 1, -1))

    parameters = {"GM": 1.0, "low": (1 - e) * (1 + sign * gap)}
    low = Event(lambda s, p, t: s.x**2 + s.y**2 - p.low**2, name="height")
    start = 1 + e, 0.0, 0.0, math.sqrt((1 - e) / (1 + e))
    T = 2 * math.pi * rng.uniform(1.2, 3.2)
    return by_accelerations(by_power, parameters, "x y", T, start, events=(low,))


@held_out("events", "forced")
def clock_ticks(rng):
    """Events of time alone, and one of the state that falls between them."""
    parameters = rng.parameters(k=(1.0, 10.0), W=(3.0, 15.0))
    tick = Event(lambda s, p, t: sin(p.W * t), 1, name="tick")
    zero = Event(lambda s, p, t: s.x, name="zero")
    T, *start = rng.values((3.0, 12.0), (0.5, 2.0), (-1.0, 1.0))
    events = tick, zero
    return by_accelerations(lambda s, p, t: (-p.k * s.x,), parameters, "x", T, start, events=events)
