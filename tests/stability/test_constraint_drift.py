"""Constraint drift: a pendulum in x, y with its rod force lambda, against the angle as the only
coordinate (5.28), (11.17).
"""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from newton_euler.scenes.planar.pendulum import physical_pendulum
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
