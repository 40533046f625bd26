"""Machines whose data are measured: tables of a torque, of a drag and of a road."""

import math

from newton_euler import sqrt, table
from tests.honesty.cases import Log, by_accelerations, by_rates, family


@family("tables", "strangers", "kinked")
def motor_with_a_torque_curve(rng):
    """A flywheel is run up by a motor whose torque is known at some speeds."""
    places = [60.0, 150.0, rng.uniform(200.0, 300.0), 420.0, 500.0]
    torques = rng.values((90.0, 110.0), (130.0, 160.0), (150.0, 190.0), (90.0, 140.0), 0.0)
    torque = table(places, torques, "linear", "hold")
    parameters = rng.parameters(J=(1.0, 5.0), M=(5.0, 40.0), c=Log(1e-5, 3e-4))
    rates = lambda s, p, t: ((torque(s.w) - p.M - p.c * s.w**2) / p.J,)
    start = (rng.uniform(101.0, 180.0),)
    return by_rates(rates, parameters, "w", rng.uniform(2.0, 15.0), start)


@family("tables", "strangers", "kinked")
def shell_with_a_drag_table(rng):
    """A shell whose coefficient of drag is known at some Mach numbers; it falls below the first."""
    machs = [0.5, 0.8, rng.uniform(0.9, 0.95), 1.1, 2.0, 3.0]
    base = rng.uniform(0.1, 0.25)
    drags = [base, base, base * 1.4, base * 3, base * 2.2, base * 1.6]
    coefficient = table(machs, drags, "linear", "hold")
    parameters = rng.parameters(g=9.81, sound=(320.0, 345.0), D=Log(1e-4, 3e-3))

    def accelerations(s, p, t):
        v = sqrt(s.dx**2 + s.dy**2)
        drag = p.D * coefficient(v / p.sound) * v
        return -drag * s.dx, -p.g - drag * s.dy

    v, angle = rng.values((350.0, 900.0), (0.2, 1.2))
    start = (0.0, 0.0, v * math.cos(angle), v * math.sin(angle))
    return by_accelerations(accelerations, parameters, "x y", rng.uniform(5.0, 50.0), start)


@family("tables", "strangers", "kinked")
def car_on_a_measured_road(rng):
    """A quarter of a car over the heights of a road, among them a pothole."""
    hole, width, v = rng.values((12.0, 30.0), Log(0.05, 1.0), (5.0, 20.0))
    places = [0.5, 3.0, 6.0, 10.0, hole, hole + width / 4, hole + 3 * width / 4, hole + width]
    heights = [0.0, *(rng.uniform(-0.03, 0.03) for _ in range(3)), 0.0, -0.05, -0.05, 0.0]
    places, heights = [*places, hole + 3.0, hole + 8.0], [*heights, rng.uniform(-0.03, 0.03), 0.0]
    height = table(places, heights, "linear", "hold")
    n = rng.uniform(5.0, 15.0)
    parameters = {"k": n * n, "c": 2 * n * rng.uniform(0.1, 0.5), "r": rng.uniform(0.0, 0.05)}
    accelerations = lambda s, p, t: (-p.r * s.dx, -p.k * (s.z - height(s.x)) - p.c * s.dz)
    T = rng.uniform(1.2, 2.0) * (hole + 5.0) / v
    return by_accelerations(accelerations, parameters, "x z", T, (0.0, 0.0, v, 0.0))
