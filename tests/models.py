"""Models for tests that need nothing above motion."""

from importlib.util import find_spec
from types import SimpleNamespace

import pytest

from newton_euler import Model, cos, sin, sqrt
from newton_euler.motion import second_order

needs_heyoka = pytest.mark.skipif(not find_spec("heyoka"), reason="heyoka is not installed")
TAYLOR = pytest.param("taylor", marks=needs_heyoka)

DRIFT = Model("drift", {}, ("x", "v"), lambda s, p, t: (s.v, 0.0 * s.v))
SPRING = second_order("spring", {"k": 4.0}, ("x",), lambda s, p, t: (-p.k * s.x,))
FALL = Model("fall", {}, ("x",), lambda s, p, t: (-1 / s.x,))  # x^2 = x0^2 - 2 t


def throw(**parameters):
    """A body thrown upwards without air, and its closed form; ``g`` is among the parameters."""
    rates = lambda s, p, t: (s.v, -p.g)
    exact = lambda s, p, t: (s.h + s.v * t - p.g * t * t / 2, s.v - p.g * t)
    return Model("throw", parameters, ("h", "v"), rates, exact=exact)


def free_body(A=1.0, B=2.0, C=3.0):
    """Euler's equations without moments."""

    def rates(s, p, t):
        x, y = (p.B - p.C) / p.A * (s.y * s.z), (p.C - p.A) / p.B * (s.z * s.x)
        return x, y, (p.A - p.B) / p.C * (s.x * s.y)

    invariants = {
        "energy": lambda s, p, t: (p.A * s.x**2 + p.B * s.y**2 + p.C * s.z**2) / 2,
        "momentum": lambda s, p, t: (p.A * s.x) ** 2 + (p.B * s.y) ** 2 + (p.C * s.z) ** 2,
    }
    return Model("free body", {"A": A, "B": B, "C": C}, ("x", "y", "z"), rates, invariants)


def kepler():
    """A planet, GM = 1."""

    def accelerations(s, p, t):
        r2 = s.x * s.x + s.y * s.y
        return -s.x / (r2 * sqrt(r2)), -s.y / (r2 * sqrt(r2))

    energy = {"energy": lambda s, p, t: (s.dx**2 + s.dy**2) / 2 - 1 / sqrt(s.x**2 + s.y**2)}
    return second_order("planet", {}, ("x", "y"), accelerations, invariants=energy)


def from_farthest(mu, a, e):
    """The state (x, y, v_x, v_y) at the farthest point of the ellipse of semi-axis a and
    eccentricity e: at x = -a(1 + e).

    >>> from_farthest(1.0, 1.0, 0.0)
    (-1.0, 0.0, 0.0, -1.0)
    """
    return -a * (1 + e), 0 * a, 0 * a, -sqrt(mu * (1 - e) / (a * (1 + e)))


def oscillator(exact=True):
    """x'' = -k x."""

    def solution(s, p, t):
        w = sqrt(p.k)
        return s.x * cos(w * t) + s.dx / w * sin(w * t), s.dx * cos(w * t) - w * s.x * sin(w * t)

    return second_order(
        "oscillator", {"k": 4.0}, ("x",), lambda s, p, t: (-p.k * s.x,), exact=solution if exact else None,
        invariants={"energy": lambda s, p, t: s.dx**2 + p.k * s.x**2},
    )  # fmt: skip


def forced():
    """Driven, damped: its rates depend on time."""
    acceleration = lambda s, p, t: (cos(1.3 * t) - p.c * s.dx - p.k * s.x - 0.3 * s.x**3,)
    return second_order("forced", {"c": 0.2, "k": 1.0}, ("x",), acceleration)


def begun(stepper, system, start, t1=5.0, t0=0.0, **options):
    """A run of a method of integration that has not taken a step.

    options : what a trajectory has, and the ``floors``, ``noise`` and ``stops`` of its limits
    """
    nothing = (0.0,) * len(start)
    usual = {"floors": nothing, "noise": nothing, "stops": ()}
    limits = [options.pop(name, x) for name, x in usual.items()]
    usual = {"tolerance": 1e-8, "max_steps": 5e6, "longest_part": 0.4, "units": ()}
    usual |= dict.fromkeys(("step", "samples")) | {"method": SimpleNamespace(order=4)}
    trajectory = SimpleNamespace(goal=t1, limits=lambda *_: limits, **usual | options)
    return stepper(system, t0, start, trajectory)
