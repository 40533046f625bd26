"""Angles across +-pi: the gradient of a wrapped angle has spikes, and unwrapping fails for steps of
more than half a turn.
"""

import math

import mpmath
import numpy as np
import pytest

from newton_euler.kinematics.rotations import RotationError, euler_from_quaternion, unwound
from newton_euler.scenes.spatial import top


def wrapped(angle):
    return np.arctan2(np.sin(angle), np.cos(angle))


def test_unwrap_takes_a_turn_of_10_rad_per_sample_for_minus_2_6_and_the_rates_tell_better():
    t = np.arange(0.0, 20.0)
    angle = 10.0 * t
    assert abs(np.diff(np.unwrap(wrapped(angle)))[0] - (10 - 4 * math.pi)) < 1e-12  # -2.57 rad
    found = unwound(wrapped(angle), 10.0 + 0 * t, t)
    assert np.max(np.abs(found - angle)) < 3e-14  # rad, of 190


def test_a_spin_that_speeds_up_is_followed_over_thousands_of_turns_in_100_samples():
    t = np.linspace(0.0, 10.0, 101)
    angle, rate = 50 * t + 40 * t**2, 50 + 80 * t
    assert np.max(np.abs(np.unwrap(wrapped(angle)) - angle)) > 1000
    assert np.max(np.abs(unwound(wrapped(angle), rate, t) - angle)) < 1e-11


def test_where_the_rates_leave_the_number_of_turns_open_it_refuses_in_words():
    t = np.array([0.0, 1.0])
    with pytest.raises(RotationError, match="how many turns there were is not known"):
        unwound([0.0, math.pi], [0.0, 0.0], t)
    with pytest.raises(RotationError, match="between t = 0 and 1 s"):
        unwound([0.0, 0.0], [0.0, math.nan], t)
    assert unwound([0.0, 1.5], [0.0, 0.0], t)[1] == 1.5


def test_the_precession_of_a_top_through_many_turns_is_continuous_to_1e_minus_12_rad():
    body, start = top.free(1.5, 1.0, 20.0), (math.cos(0.3), math.sin(0.3), 0.0, 0.0, 0.0, 2.0)
    t = np.linspace(0.0, 100.0, 401)
    *q, w_x, w_y = body.solution(t, start)
    psi, theta, phi = euler_from_quaternion(q)
    rate = (w_x * np.sin(phi) + w_y * np.cos(phi)) / np.sin(theta)
    found, exact = unwound(psi, rate, t), body.solution(mpmath.mpf(100), start)
    assert abs(wrapped(found[-1]) - float(euler_from_quaternion(exact[:4])[0])) < 1e-12
    assert np.all(np.abs(np.diff(found) - np.diff(t) * (rate[1:] + rate[:-1]) / 2) < math.pi / 2)
