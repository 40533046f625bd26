"""Constraint drift: a pendulum in x, y with its rod force lambda, against the angle as the one
coordinate (5.28), (11.17).
"""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from newton_euler.dynamics.constraints import degrees_of_freedom
from newton_euler.scenes.particles.orbit import orbit
from newton_euler.scenes.planar.pendulum import physical_pendulum
from newton_euler.scenes.planar.rolling_sphere import rolling_down
from newton_euler.scenes.spatial import top
from newton_euler.scenes.spatial.free_body import free_body
from newton_euler.scenes.spatial.spherical_pendulum import nodding
from tests.stability.naive import TIGHT, solved

L, G, THETA0 = 1.0, 9.81, 1.0


def test_the_rod_of_length_1_is_metres_long_after_100_s_with_the_default_solver():
    def with_multiplier(t, state):
        x, y, vx, vy = state.tolist()
        force = (vx * vx + vy * vy + G * y) / (x * x + y * y)
        return [vx, vy, -force * x, G - force * y]

    start = [math.sin(THETA0), math.cos(THETA0), 0.0, 0.0]
    x, y, *_ = solve_ivp(with_multiplier, (0, 100.0), start).y[:, -1]
    assert abs(math.hypot(x, y) - L) > 1.0


def test_with_the_angle_as_the_state_the_length_cannot_drift_and_the_energy_keeps_10_digits_at_1e_minus_10():
    model = physical_pendulum(1.0, 0.0, L, G)
    assert model.states == ("theta", "omega")
    y = solved(model, 20.0, (THETA0, 0.0), **TIGHT).y
    assert math.hypot(L * math.sin(y[0, -1]), L * math.cos(y[0, -1])) == pytest.approx(L, abs=2e-16)
    energy = [model.invariant("energy", s) for s in y.T.tolist()]
    assert np.ptp(energy) < 1e-8  # J, of 5


def test_the_states_are_twice_the_degrees_of_freedom_that_the_constraints_leave():
    pendulum = degrees_of_freedom(
        {"P": "particle in plane"}, {"rod": lambda P: P[0] ** 2 + P[1] ** 2 - L**2}
    )
    assert len(physical_pendulum(1.0, 0.0, L, G).states) == 2 * pendulum.count
    rolls = {"contact": lambda ball: ball[1] - 0.5, "no slip": lambda ball: ball[0] + 0.5 * ball[2]}
    rolling = degrees_of_freedom({"ball": "body in plane"}, rolls)
    assert len(rolling_down(0.3, G).states) == 2 * rolling.count


@pytest.mark.parametrize(
    ("model", "count"),
    [
        (physical_pendulum(1.0, 0.1, L, G), 2),  # theta
        (nodding(1.0, L, G, 2.0, 0.1), 2),  # theta; psi is cyclic
        (top.nutation(1.5, 1.0, 5.0, 8.0, 0.1), 2),  # theta; psi and phi are cyclic
        (top.euler(1.5, 1.0, 5.0, 8.0), 5),  # three angles, two rates; omega_z is constant
        (orbit(1.0), 4),  # x, y
        (free_body(1.0, 2.0, 3.0), 3),  # rates alone; the attitude is not asked for
    ],
)
def test_the_state_of_a_scene_has_no_component_that_a_constraint_could_drift_in(model, count):
    assert len(model.states) == count


def test_a_quaternion_has_one_component_too_many_and_its_drift_is_an_invariant_that_is_watched():
    model = top.nonspinning_frame(1.5, 1.0, 5.0, 8.0)
    assert len(model.states) == 6  # 5 and the norm
    assert "norm" in model.invariants
