"""Rotation matrices multiplied out, and sums, multiples and products of vectors."""

import pytest
from mpmath import mp, mpf

from exercises.catalogue.proofs.vectors import (
    at_angle,
    cross,
    minus,
    plus,
    rot,
    scaled,
    size,
    times,
    transposed,
)
from tests.exercises.catalogue.proofs.near import near


@pytest.mark.parametrize(
    ("axis", "start", "end"), [("x", "y", "z"), ("y", "z", "x"), ("z", "x", "y")]
)
def test_rot_is_right_handed(axis, start, end):
    unit = {"x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1]}
    assert near(times(rot(axis, mp.pi / 2), unit[start]), unit[end])
    assert near(rot(unit[axis], mpf("0.3")), rot(axis, mpf("0.3")))


def test_rot_about_any_axis_is_the_exponential_of_its_cross_product():
    e, angle = [2, -1, 2], mpf("0.7")  # length 3
    skew = mp.matrix([[0, -2, -1], [2, 0, -2], [1, 2, 0]]) * angle / 3
    assert near(rot(e, angle), mp.expm(skew).tolist())


def test_times_multiplies_from_the_left_and_transposed_turns_back():
    R, S, v = rot("x", mpf("0.4")), rot([1, 2, 3], 2), [mpf(1), mpf(-2), mpf(5)]
    assert near(times(R, S, v), times(R, times(S, v)))
    assert near(times(times(R, S), v), times(R, S, v))
    assert near(times(transposed(R), R, v), v)


def test_vector_tools():
    a, b = [1, 2, 2], [0, -1, 4]
    assert plus(a, b, a) == [2, 3, 8]
    assert minus(a, b) == [1, 3, -2]
    assert scaled(3, a) == [3, 6, 6]
    assert size(a) == 3
    assert cross(a, b) == [10, -4, -1]


def test_at_angle_is_x_turned_about_z_and_raised():
    turned = times(rot("z", mpf("0.7")), [mpf(2), 0, 5])
    assert near(at_angle(mpf(2), mpf("0.7"), 5), turned)
    assert at_angle(mpf(2), 0)[2] == 0
