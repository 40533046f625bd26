"""A rod hinged on a turning shaft: at the critical rate hanging down gives way to swinging out, a
pitchfork (10.7), (10.31).
"""

import math

import mpmath
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from newton_euler.applications.gyroscopes import GyroError
from newton_euler.motion.integration import integrate
from newton_euler.scenes.planar.hinged_rod import hinged, least_rate, rod, stiffness, swing_out

G, LENGTH, MASS = 9.81, 2.0, 3.0
CRITICAL = least_rate(**rod(MASS, LENGTH, 1.0, G))  # sqrt(3 g/(2 L)), 2.71 rad/s


def turning(ratio):
    """The parameters of the rod at ``ratio`` times the critical rate."""
    return rod(MASS, LENGTH, ratio * CRITICAL, G)


def exact_angle(parameters):
    with mpmath.workdps(40):
        c = mpmath.mpf(parameters["weight_moment"]) / (
            mpmath.mpf(parameters["inertia_difference"]) * mpmath.mpf(parameters["omega"]) ** 2
        )
        return mpmath.acos(c)


@pytest.mark.parametrize("off", [1e-2, 1e-6, 1e-10, 1e-14])
def test_the_criterion_decides_on_both_sides_down_to_1e_minus_14_of_the_rate(off):
    assert stiffness(0.0, **turning(1 - off)) > 0 > stiffness(0.0, **turning(1 + off))
    assert stiffness(swing_out(**turning(1 + off)), **turning(1 + off)) > 0


@given(st.floats(-13, 0.5))
def test_above_it_the_angle_is_right_to_the_rounding_of_the_rate_over_the_distance_from_the_threshold(
    exponent,
):
    parameters = turning(1 + 10**exponent)
    assert abs(swing_out(**parameters) / exact_angle(parameters) - 1) < 4e-16 / 10**exponent + 4e-16


@pytest.mark.parametrize("off", [1e-2, 1e-8, 1e-14])
def test_below_it_the_engine_refuses_an_angle_and_says_from_which_rate_on_there_is_one(off):
    with pytest.raises(
        GyroError, match=r"the body hangs straight down; it swings out above 2\.712"
    ):
        swing_out(**turning(1 - off))


@pytest.mark.parametrize("off", [1e-1, 1e-3, 1e-5])
def test_small_swings_about_the_new_angle_have_the_frequency_of_the_criterion(off):
    """On both sides of the threshold; the softer the rod, the smaller the swing must be."""
    for ratio, theta in ((1 + off, swing_out(**turning(1 + off))), (1 - off, 0.0)):
        parameters = turning(ratio)
        period = 2 * math.pi / math.sqrt(stiffness(theta, **parameters))
        swing = 1e-4 * math.sqrt(off)
        motion = integrate(hinged(**parameters), period, (theta + swing, 0.0), rtol=1e-9)
        assert motion.end["theta"] - theta == pytest.approx(swing, rel=1e-5)
        half = motion.at(period / 2)
        assert half["theta"] - theta == pytest.approx(-swing, rel=1e-3)


def test_many_rates_at_once_are_told_apart():
    ratios = np.array([1.001, 1.1, 2.0])
    angles = swing_out(**turning(ratios))
    assert np.all(np.diff(angles) > 0)
    with pytest.raises(GyroError, match="hangs straight down"):
        swing_out(**turning(np.array([0.9, 1.1])))
