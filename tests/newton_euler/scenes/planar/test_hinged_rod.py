"""Section 10.7: a body hinged to a turning shaft, below and above the rate of swinging out."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Frame, Inertia
from newton_euler.applications import GyroError, steady_precession
from newton_euler.scenes.planar.hinged_rod import hinged, least_rate, rod, stiffness, swing_out


def test_section_10_7_rod_on_a_turning_shaft():
    data = rod(3.0, 2.0, 4.0, 9.81)
    theta = swing_out(**data)
    assert math.cos(theta) == pytest.approx(3 * 9.81 / (2 * 16.0 * 2.0), rel=1e-15)
    assert least_rate(**data) == pytest.approx(math.sqrt(3 * 9.81 / 4.0), rel=1e-15)
    assert hinged(**data).derivative((theta, 0.0))[1] == pytest.approx(0, abs=1e-14)
    # (10.31) with r = -L/2, I = 0, k up along the rod
    found = steady_precession(4.0, 0, theta, spin=0, mgr=-3.0 * 9.81 * 1.0)
    assert abs(found.slow) == pytest.approx(4.0, rel=1e-14)


def turning(ratio):
    """The rod of 3 kg and 2 m at ``ratio`` times the rate at which it swings out."""
    return rod(3.0, 2.0, ratio * least_rate(**rod(3.0, 2.0, 1.0, 9.81)), 9.81)


@pytest.mark.parametrize("off", [1e-2, 1e-6, 1e-10, 1e-14])
def test_section_10_7_on_both_sides_of_the_least_rate(off):
    below, above = turning(1 - off), turning(1 + off)
    assert stiffness(0.0, **below) > 0 > stiffness(0.0, **above)
    theta = swing_out(**above)
    assert stiffness(theta, **above) == pytest.approx((above["omega"] * math.sin(theta)) ** 2)
    for data in (below, turning(np.array([1 - off, 1.1]))):
        with pytest.raises(GyroError, match=r"hangs straight down; it swings out above 2\.712"):
            swing_out(**data)


@given(st.floats(-13, 0.5))
def test_section_10_7_the_angle_is_right_to_the_rounding_of_the_rate_over_the_distance(exponent):
    data = turning(1 + 10**exponent)
    with mp.workdps(40):
        weight, difference, omega = (mp.mpf(data[n]) for n in ("weight_moment", "inertia_difference", "omega"))  # fmt: skip
        true = mp.acos(weight / (difference * omega**2))
    assert abs(swing_out(**data) / true - 1) < 4e-16 / 10**exponent + 4e-16


def test_section_10_7_stiffness_is_the_slope_of_the_model():
    data = rod(*(mp.mpf(x) for x in ("3", "2", "4", "9.81")))
    theta = swing_out(**data)
    slope = mp.diff(lambda x: hinged(**data).derivative((x, 0))[1], theta)
    assert abs(slope + stiffness(theta, **data)) < mp.mpf(10) ** -12


def test_exercise_9_9_ring_on_a_turning_shaft():
    a, omega, g, m = 0.5, 8.0, 9.81, 2.0
    body, unit = Frame("ring"), m * a * a
    own = Inertia(body.origin, (unit / 2, unit, unit / 2), mass=m, centre=body.origin)
    hinge, across, along = own.about(body.point("A", 0, 0, a)).moments
    data = {"weight_moment": m * g * a, "inertia_difference": across - along, "about_hinge": hinge}
    data["omega"] = omega
    assert math.cos(swing_out(**data)) == pytest.approx(2 * g / (3 * a * omega**2), rel=1e-14)
    assert least_rate(**data) == pytest.approx(math.sqrt(2 * g / (3 * a)), rel=1e-14)
