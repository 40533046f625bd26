"""Energy and momentum that explicit methods lose or gain, on the oscillator and on the free body,
against closed forms (8.14), (11.32).
"""

import math

import mpmath
import numpy as np
import pytest

from newton_euler.scenes.spatial.free_body import free_body
from tests.kinds import close
from tests.stability.naive import solved

BODY, START = free_body(1.0, 2.0, 3.0), (0.01, 1.0, 0.01)
OSCILLATOR = np.array([[0.0, 1.0], [-1.0, 0.0]])  # x'' = -x
T = 100 * 2 * math.pi


def energy_after(step_matrix, h):
    """Energy after 100 periods over that at the start; one step of the method multiplies the state
    by the matrix.
    """
    y = np.linalg.matrix_power(step_matrix, round(T / h)) @ np.array([1.0, 0.0])
    return float(y @ y)


def euler(h):
    return np.eye(2) + h * OSCILLATOR


def rk4(h):
    z = h * OSCILLATOR
    return np.eye(2) + z + z @ z / 2 + z @ z @ z / 6 + z @ z @ z @ z / 24


def drift(y, what):
    values = [BODY.invariant(what, state) for state in y.T.tolist()]
    return max(abs(v / values[0] - 1) for v in values)


@pytest.mark.parametrize(("h", "times"), [(0.1, 1e27), (0.01, 535.0), (0.001, 1.87)])
def test_euler_multiplies_the_energy_of_an_oscillator_by_1e27_in_100_periods_and_by_1_9_at_a_tiny_step(
    h, times
):
    assert energy_after(euler(h), h) == pytest.approx(times, rel=0.6)


def test_runge_kutta_of_fourth_order_loses_energy_at_the_rate_h_to_the_6th_over_72_a_step():
    for h in (0.1, 0.05):
        assert 1 - energy_after(rk4(h), h) == pytest.approx(round(T / h) * h**6 / 72, rel=0.02)


def test_the_default_solver_loses_most_of_the_energy_of_a_free_body_in_2000_s():
    y = solved(BODY, 2000.0, START).y
    assert drift(y, "energy") > 0.3
    assert drift(y, "momentum") > 0.15


@pytest.mark.parametrize(("method", "rtol", "more", "less"), [
    ("RK45", 1e-6, 1e-6, 1e-3), ("DOP853", 1e-6, 1e-7, 1e-3), ("DOP853", 1e-10, 1e-12, 1e-7),
])  # fmt: skip
def test_a_tighter_tolerance_only_slows_the_drift(method, rtol, more, less):
    y = solved(BODY, 300.0, START, method=method, rtol=rtol, atol=rtol).y
    assert more < drift(y, "energy") < less


@pytest.mark.parametrize(("t", "error"), [(50.0, 1e-14), (1e4, 1e-12), (1e6, 1e-10)])
def test_the_closed_form_is_right_to_a_round_off_of_the_time_passed(t, error):
    assert close(BODY.solution(t, START), BODY.solution(mpmath.mpf(t), START), error)  # rad/s
