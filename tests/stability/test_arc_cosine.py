"""Angles by arc cosine: near 0 and pi half of the digits are lost, and rounding can leave its
domain (4.2), (A.11).
"""

import math

import mpmath
import numpy as np
import pytest

from newton_euler.accuracy.measurements.baselines import by_arc_cosine
from newton_euler.kinematics.rotations import axis_angle, in_sequence, rotation_matrix
from tests.kinds import close

AXIS = (0.36, 0.48, 0.8)


def axis_by_skew_part(R):
    v = np.array([R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]])
    return v / np.linalg.norm(v)


@pytest.mark.parametrize(
    ("angle", "naive"),
    [(1e-4, 1e-13), (1e-7, 1e-10), (1e-9, 9e-10), (math.pi - 1e-7, 1e-10), (math.pi - 1e-9, 9e-10)],
)
def test_the_arc_cosine_loses_all_digits_of_an_angle_of_1e_minus_9_rad_and_the_engine_none(
    angle, naive
):
    R = rotation_matrix(AXIS, angle)
    assert abs(by_arc_cosine(R) - angle) > naive  # rad
    axis, found = axis_angle(R)
    assert abs(found - angle) < 4e-16 * max(1.0, angle)
    assert close(axis, AXIS, 1e-15 / min(angle, 1.0) if angle < 1 else 1e-15)


def test_unclipped_it_is_not_a_number_for_many_turns_there_and_back():
    axes = np.random.default_rng(1).normal(size=(200, 3)).tolist()
    there_and_back = [
        in_sequence(rotation_matrix(axis, 1.0), rotation_matrix(axis, -1.0)) for axis in axes
    ]
    with np.errstate(invalid="ignore"):
        angles = np.array([np.arccos((np.trace(R) - 1) / 2) for R in there_and_back])
    assert np.isnan(angles).sum() > 10
    assert np.nanmax(angles) > 1.4e-8  # rad
    assert all(axis_angle(R)[1] < 1e-15 for R in there_and_back)


def test_the_axis_from_the_skew_part_is_lost_at_pi_and_the_engine_keeps_15_digits():
    R = rotation_matrix(AXIS, math.pi)
    assert (
        np.linalg.norm(axis_by_skew_part(R) - AXIS) > 0.1
        or np.linalg.norm(axis_by_skew_part(R) + AXIS) > 0.1
    )
    near = rotation_matrix(AXIS, math.pi - 1e-8)
    assert np.linalg.norm(axis_by_skew_part(near) - AXIS) > 1e-9
    for M in (R, near):
        assert close(axis_angle(M)[0], AXIS, 1e-15)


@pytest.mark.parametrize(
    "angle", [0.0, 1e-300, 1e-20, 1e-12, 1e-3, 1.0, 3.0, math.pi - 1e-3, math.pi - 1e-12, math.pi]
)
def test_the_turn_is_given_back_over_the_whole_range_to_2_round_offs(angle):
    axis, found = axis_angle(rotation_matrix(AXIS, angle))
    assert abs(found - angle) <= 4.5e-16 * max(angle, 1e-300)
    assert close(rotation_matrix(axis, found), rotation_matrix(AXIS, angle), 5e-16)


def test_with_30_digits_arc_cosine_still_loses_half_of_them_and_the_engine_none():
    angle = mpmath.mpf("1e-14")
    R = rotation_matrix(tuple(map(mpmath.mpf, ("0.36", "0.48", "0.8"))), angle)
    trace = mpmath.acos((R[0][0] + R[1][1] + R[2][2] - 1) / 2)
    assert abs(trace - angle) / angle > 1e-4
    assert abs(axis_angle(R)[1] - angle) / angle < 1e-15
