"""Motions for tests: models with starts and times, and their final states with 30 digits.

The references come from heyoka in multiple precision (40 digits, other arithmetic and order than any method under test; ``test_motion.py``
compares it with ``mpmath.odefun``).
"""

import math
from dataclasses import replace
from functools import cache

from newton_euler import Model, cos, second_order, sin, sqrt
from newton_euler.scenes import top
from newton_euler.scenes.aircraft import vertical_flight
from newton_euler.scenes.physical_pendulum import physical_pendulum
from newton_euler.scenes.projectile import full
from newton_euler.scenes.spherical_pendulum import pendulum
from newton_euler.scenes.turning_shaft import hinged, rod
from newton_euler.systems import System

SPIN = 8.0  # of the nutating top of ENGINES.md: I0 = 1, I = 1.5, mgr = 5, theta = 0.6


def free_body(A=1.0, B=2.0, C=3.0):
    """Euler's equations without moments."""

    def rates(s, p, t):
        return (p.B - p.C) / p.A * (s.y * s.z), (p.C - p.A) / p.B * (s.z * s.x), (p.A - p.B) / p.C * (s.x * s.y)

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
    return second_order("forced", {"c": 0.2, "k": 1.0}, ("x",), lambda s, p, t: (cos(1.3 * t) - p.c * s.dx - p.k * s.x - 0.3 * s.x**3,))


def top_start(theta=0.6):
    """At rest but for the spin."""
    return math.cos(theta / 2), math.sin(theta / 2), 0.0, 0.0, 0.0, 0.0


SCENES = {
    "top": (top.rolled_out(1.0, 1.5, 5.0, SPIN), 10.0, top_start()),
    "top, nutation": (top.reduced(1.0, 1.5, 5.0, SPIN, top.surplus(1.0, 1.5, 0.6, 0.0, SPIN)), 10.0, (0.6, 0.0)),
    "top, angles": (top.euler(1.0, 1.5, 5.0, SPIN), 10.0, (0.0, 0.6, 0.0, 0.0, 0.0)),
    "free body": (free_body(), 50.0, (0.01, 1.0, 0.01)),
    "free body, calm": (free_body(1.0, 1.5, 2.2), 20.0, (1.0, 0.1, 0.4)),
    "pendulum": (physical_pendulum(2.0, 0.5, 0.5, 10.0), 10.0, (1.0, 0.0)),
    "pendulum, over the top": (physical_pendulum(2.0, 0.5, 0.5, 10.0), 15.0, (3.1, 0.0)),
    "spherical pendulum": (pendulum(3.0, 2.0, 9.81), 8.0, (math.cos(1.2), math.sin(1.2), 0.0, 0.0, 0.1, 0.7)),
    "turning shaft": (hinged(**rod(3.0, 2.0, 4.0, 9.81)), 12.0, (0.2, 0.5)),
    "projectile": (full(9.82, 0.8), 40.0, (0.0, 0.0, 0.0, 200.0, 50.0, 200.0)),
    "aircraft": (vertical_flight(2.0, 9.81, thrust=12.0, drag=lambda s, p, t: 0.004 * s.v * s.v, lift=25.0), 20.0, (50.0, 0.1, 0.0, 100.0)),
    "planet": (kepler(), 30.0, (1.0, 0.0, 0.0, 1.2)),
    "planet, eccentric": (kepler(), 20.0, (1.0, 0.0, 0.0, 0.5)),
    "forced": (forced(), 25.0, (0.3, 0.0)),
    "oscillator": (oscillator(exact=False), 20.0, (1.0, 0.3)),
}


@cache
def reference(name):
    """The final state, 40 digits kept as floats."""
    import heyoka as hy

    model, t, start = SCENES[name]
    system = System(model)
    variables = [hy.expression(n) for n in model.states]
    one = hy.real(1, 140)
    outputs = system.traced.rhs(hy.time, *variables, *(hy.par[i] for i in range(len(system.free))))
    equations = [(v, o + hy.expression(0.0)) for v, o in zip(variables, outputs, strict=True)]
    ta = hy.taylor_adaptive(equations, [one * x for x in start], fp_type=hy.real, prec=140, compact_mode=True)
    for i in range(len(ta.pars)):
        ta.pars[i] = one * system.p[i]
    ta.propagate_until(one * t)
    return tuple(float(x) for x in ta.state)


@cache
def sizes(name):
    """The largest size of each state on the way, at least 1e-6: what errors are relative to."""
    from newton_euler.motion import integrate

    model, t, start = SCENES[name]
    motion = integrate(replace(model, exact=None), t, start, 1e-6, "dop853")
    return {n: max(float(abs(x).max()), 1e-6) for n, x in motion.states.items()}


def true_error(name, motion):
    """Of the last state, as ``Motion.error`` counts it."""
    return max(abs(motion.end[n] - x) / sizes(name)[n] for n, x in zip(SCENES[name][0].states, reference(name), strict=True))
