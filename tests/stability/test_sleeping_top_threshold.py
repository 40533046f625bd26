"""The sleeping top at its critical spin: a finite run cannot tell stable from unstable, the
criterion can (10.7).
"""

import math

import numpy as np
import pytest

from newton_euler.applications.gyroscopes import sleeping_top
from newton_euler.applications.nutation import nutation
from newton_euler.scenes.spatial import top
from tests.stability.naive import solved

I0, I, MGR = 1.5, 1.0, 5.0
CRITICAL = 2 * math.sqrt(I0 * MGR) / I
TILT = 1e-6  # rad


def largest_tilt(ratio, T=200.0):
    """The largest angle (rad) within T seconds from a tilt of 1e-6 rad, by integration."""
    omega_z = ratio * CRITICAL
    model = top.nonspinning_frame(I0, I, MGR, omega_z)
    start = (math.cos(TILT / 2), math.sin(TILT / 2), 0.0, 0.0, 0.0, 0.0)
    y = solved(model, T, start, method="DOP853", rtol=1e-9, atol=1e-13, max_step=0.5).y
    return 2 * np.max(np.hypot(y[1], y[2]) / np.linalg.norm(y[:4], axis=0))


def test_a_run_of_200_s_calls_a_top_at_0_9999_of_the_critical_spin_upright_and_the_criterion_does_not():
    assert largest_tilt(0.99) > 0.1  # rad: falls
    assert largest_tilt(0.9999) < 0.02
    assert not sleeping_top(I0, I, MGR, 0.9999 * CRITICAL).stable


@pytest.mark.parametrize(("ratio", "stable"), [
    (0.9, False), (1 - 1e-6, False), (1 - 1e-12, False), (1 + 1e-12, True), (1 + 1e-6, True),
    (1.1, True),
])  # fmt: skip
def test_the_criterion_decides_on_both_sides_down_to_1e_minus_12_of_the_critical_spin(
    ratio, stable
):
    found = sleeping_top(I0, I, MGR, ratio * CRITICAL)
    assert found.stable is stable
    assert (found.growth > 0) is not stable
    assert found.critical == pytest.approx(CRITICAL, rel=1e-15)
    assert found.margin == pytest.approx(ratio**2, rel=1e-14)


@pytest.mark.parametrize("below", [1e-2, 1e-6, 1e-10])
def test_the_growth_just_below_the_threshold_is_right_to_round_off_over_the_distance(below):
    found = sleeping_top(I0, I, MGR, (1 - below) * CRITICAL)
    exact = math.sqrt(MGR / I0) * math.sqrt(below * (2 - below))
    assert found.growth == pytest.approx(exact, rel=4e-16 / below)


@pytest.mark.parametrize("below", [1e-1, 1e-2, 1e-4])
def test_how_far_it_falls_from_upright_and_rest_is_that_of_the_energy(below):
    """cos(theta_max) = 2 (I omega_z)^2/(4 I0 mgr) - 1"""
    found = nutation(I0, I, MGR, 1e-9, 0.0, 0.0, omega_z=(1 - below) * CRITICAL)
    assert found.theta_max == pytest.approx(math.acos(2 * (1 - below) ** 2 - 1), rel=1e-8)


def test_just_above_the_threshold_the_nod_stays_as_small_as_the_start():
    assert nutation(I0, I, MGR, 1e-6, 0.0, 0.0, omega_z=1.001 * CRITICAL).theta_max < 1e-4  # rad
