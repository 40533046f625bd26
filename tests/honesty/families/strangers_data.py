"""Machines whose data are measured: tables of a torque, of a drag and of a road."""

import math
from itertools import pairwise

from newton_euler import Model, sqrt, table
from newton_euler.motion import second_order
from tests.honesty.cases import Branches, Case, Log, family


class _Measured:
    """A linear table that keeps its values beyond its ends; and its pieces, by the signs of
    ``x - place`` for each place.
    """

    def __init__(self, places, values):
        self.read = table(places, values, "linear", "hold")
        self.places, self.first = places, values[0]
        points = list(zip(places, values, strict=True))
        slopes = [(f - e) / (b - a) for (a, e), (b, f) in pairwise(points)]
        self.turns = [b - a for a, b in pairwise([0.0, *slopes, 0.0])]

    def pieces(self, x, b):
        """The value at x."""
        value = self.first
        for sign, turn, place in zip(b, self.turns, self.places, strict=True):
            value += (1 + sign) / 2 * turn * (x - place)
        return value


@family("tables", "strangers", "kinked")
def motor_with_a_torque_curve(rng):
    """A flywheel is run up by a motor whose torque is known at some speeds."""
    places = [60.0, 150.0, rng.uniform(200.0, 300.0), 420.0, 500.0]
    torques = rng.values((90.0, 110.0), (130.0, 160.0), (150.0, 190.0), (90.0, 140.0), 0.0)
    curve = _Measured(places, torques)
    parameters = rng.parameters(J=(1.0, 5.0), M=(5.0, 40.0), c=Log(1e-5, 3e-4))
    rates = lambda s, p, torque: ((torque - p.M - p.c * s.w**2) / p.J,)
    model = Model("torque curve", parameters, ("w",), lambda s, p, t: rates(s, p, curve.read(s.w)))
    pieces = lambda s, p, t, b: rates(s, p, curve.pieces(s.w, b))
    switches = tuple(lambda s, p, t, x=x: s.w - x for x in places)
    start = (rng.uniform(101.0, 180.0),)
    return Case(model, rng.uniform(2.0, 15.0), start, branches=Branches(switches, pieces))


@family("tables", "strangers", "kinked")
def shell_with_a_drag_table(rng):
    """A shell whose coefficient of drag is known at some Mach numbers; it falls below the first."""
    machs = [0.5, 0.8, rng.uniform(0.9, 0.95), 1.1, 2.0, 3.0]
    base = rng.uniform(0.1, 0.25)
    drags = [base, base, base * 1.4, base * 3, base * 2.2, base * 1.6]
    curve = _Measured(machs, drags)
    parameters = rng.parameters(g=9.81, sound=(320.0, 345.0), D=Log(1e-4, 3e-3))

    def rates(s, p, v, coefficient):
        drag = p.D * coefficient * v
        return -drag * s.dx, -p.g - drag * s.dy

    speed = lambda s: sqrt(s.dx**2 + s.dy**2)

    def accelerations(s, p, t):
        v = speed(s)
        return rates(s, p, v, curve.read(v / p.sound))

    def pieces(s, p, t, b):
        v = speed(s)
        return s.dx, s.dy, *rates(s, p, v, curve.pieces(v / p.sound, b))

    switches = tuple(lambda s, p, t, m=m: (s.dx**2 + s.dy**2) / p.sound**2 - m * m for m in machs)
    v, angle = rng.values((350.0, 900.0), (0.2, 1.2))
    start = (0.0, 0.0, v * math.cos(angle), v * math.sin(angle))
    model = second_order("shell", parameters, ("x", "y"), accelerations)
    return Case(model, rng.uniform(5.0, 50.0), start, branches=Branches(switches, pieces))


@family("tables", "strangers", "kinked")
def car_on_a_measured_road(rng):
    """A quarter of a car over the heights of a road, among them a pothole."""
    hole, width, v = rng.values((12.0, 30.0), Log(0.05, 1.0), (5.0, 20.0))
    places = [0.5, 3.0, 6.0, 10.0, hole, hole + width / 4, hole + 3 * width / 4, hole + width]
    heights = [0.0, *(rng.uniform(-0.03, 0.03) for _ in range(3)), 0.0, -0.05, -0.05, 0.0]
    places, heights = [*places, hole + 3.0, hole + 8.0], [*heights, rng.uniform(-0.03, 0.03), 0.0]
    road = _Measured(places, heights)
    n = rng.uniform(5.0, 15.0)
    parameters = {"k": n * n, "c": 2 * n * rng.uniform(0.1, 0.5), "r": rng.uniform(0.0, 0.05)}

    def rates(s, p, height):
        return -p.r * s.dx, -p.k * (s.z - height) - p.c * s.dz

    model = second_order("measured road", parameters, ("x", "z"),
                         lambda s, p, t: rates(s, p, road.read(s.x)))  # fmt: skip
    pieces = lambda s, p, t, b: (s.dx, s.dz, *rates(s, p, road.pieces(s.x, b)))
    switches = tuple(lambda s, p, t, x=x: s.x - x for x in places)
    return Case(model, rng.uniform(1.2, 2.0) * (hole + 5.0) / v, (0.0, 0.0, v, 0.0),
                branches=Branches(switches, pieces))  # fmt: skip
