"""Spin about the intermediate principal axis: exactly on it a run in floats stays there for ever,
beside it the body turns over (8.14).
"""

import math

import pytest

from newton_euler.chapters.examples.ch10 import tilt_growth
from newton_euler.scenes.spatial.free_body import free_body
from tests.stability.naive import solved

BODY = free_body(1.0, 2.0, 3.0)
GROWTH = 1 / math.sqrt(3)  # 1/s, at 1 rad/s


def test_exactly_on_the_axis_a_run_of_floats_never_leaves_and_so_shows_nothing():
    start = 0.0, 1.0, 0.0
    assert not solved(BODY, 1e4, start).y[[0, 2]].any()
    assert BODY.solution(1e4, start) == start  # nor does the exact one: it is an equilibrium


def test_the_criterion_tells_stable_from_unstable_where_the_run_cannot():
    assert tilt_growth(1.0, 2.0, 3.0, "y", 1.0) == pytest.approx(GROWTH, rel=1e-15)
    assert tilt_growth(1.0, 2.0, 3.0, "x", 1.0) == tilt_growth(1.0, 2.0, 3.0, "z", 1.0) == 0.0
    # equal moments: a tilt drifts, but does not grow exponentially
    assert tilt_growth(2.0, 2.0, 3.0, "y", 1.0) == 0.0
    assert tilt_growth(2.0 - 1e-9, 2.0, 3.0, "y", 1.0) == pytest.approx(
        math.sqrt(1e-9 / 6), rel=1e-6
    )


@pytest.mark.parametrize("tilt", [1e-2, 1e-8, 1e-16, 1e-100])
def test_from_any_tilt_the_exact_motion_turns_over_when_the_growth_says(tilt):
    over = math.log(4 / tilt) / GROWTH  # s, the quarter period for a small tilt: 10, 34, 66, 400
    round_off = 4 * 2.2e-16 * over  # of the time, at a rate of 1 rad/s
    # rad/s: w_y has come down to zero
    assert abs(BODY.solution(over, (tilt, 1.0, 0.0))[1]) < max(1e-3 * (tilt / 1e-2) ** 2, round_off)


@pytest.mark.parametrize("tilt", [1e-3, 1e-7, 1e-14])
def test_beside_the_axis_the_growth_of_the_tilt_is_that_of_the_criterion(tilt):
    start = (tilt, 1.0, -tilt / math.sqrt(3))  # the direction that grows
    T = 1.0
    grown = BODY.solution(T, start)[0] / tilt
    assert grown == pytest.approx(math.exp(GROWTH * T), rel=max(1e-12, 2 * tilt**2))
