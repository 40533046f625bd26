"""Which runs are covered by one whose error was estimated."""

import math

import pytest

from newton_euler.motion.verified import NEAR_END, NEAR_START, SPARE, Verified, near

RTOL, START, END = 1e-9, (1.0, 2.0), (3.0, -4.0)
BESIDE, BESIDE_END = (1.01, 2.0), (3.1, -4.0)


def verified(error):
    """A record that holds one verified run, from 0 to 10."""
    runs = Verified()
    runs.add(RTOL, 0.0, 10.0, START, END, error)
    return runs


def test_nothing_is_covered_before_a_run_is_verified():
    assert not Verified().covers(RTOL, 0.0, 10.0, START, END)


def test_the_same_run_is_covered_even_if_it_is_only_just_as_accurate_as_asked():
    assert verified(RTOL).covers(RTOL, 0.0, 10.0, START, END)


@pytest.mark.parametrize(
    ("rtol", "t0", "t1"),
    [(1e-10, 0.0, 10.0), (1e-8, 0.0, 10.0), (RTOL, 0.1, 10.0), (RTOL, 0.0, 9.9), (RTOL, 0.0, 11.0)],
)
def test_a_run_of_another_rtol_or_time_is_not_covered(rtol, t0, t1):
    assert not verified(0.0).covers(rtol, t0, t1, START, END)


@pytest.mark.parametrize("start", [BESIDE, START])
def test_a_run_beside_it_is_covered_only_if_there_is_something_to_spare(start):
    """This also holds for a run from the same start with other steps."""
    beside = RTOL, 0.0, 10.0, start, BESIDE_END
    assert verified(RTOL / SPARE).covers(*beside)
    assert not verified(1.01 * RTOL / SPARE).covers(*beside)


def test_a_run_far_from_it_is_not_covered():
    far = (2.0, 2.0)
    assert not verified(0.0).covers(RTOL, 0.0, 10.0, far, END)
    assert not verified(0.0).covers(RTOL, 0.0, 10.0, BESIDE, (3.0, 4.0))


def test_the_last_run_of_each_rtol_counts():
    runs = verified(0.0)
    runs.add(1e-6, 0.0, 10.0, START, END, 0.0)
    runs.add(RTOL, 0.0, 5.0, START, END, 0.0)
    assert not runs.covers(RTOL, 0.0, 10.0, START, END)
    assert runs.covers(RTOL, 0.0, 5.0, START, END)
    assert runs.covers(1e-6, 0.0, 10.0, START, END)


@pytest.mark.parametrize("size", [1e-150, 1.0, 1e150])
@pytest.mark.parametrize("sign", [1, -1])
def test_nearness_is_relative_to_the_size_of_each_state(size, sign):
    """The size is the largest of the four values, whichever that is."""
    one = sign * size
    x = one, one

    def moved(start, end):
        here = ((1 - start) * one, one), ((1 - end) * one, one)
        return near(*here, x, x), near(x, x, *here)

    assert moved(0.99 * NEAR_START, 0.99 * NEAR_END) == (True, True)
    assert moved(1.01 * NEAR_START, 0.0) == (False, False)
    assert moved(0.0, 1.01 * NEAR_END) == (False, False)


@pytest.mark.parametrize("place", range(4))
@pytest.mark.parametrize("sign", [1, -1])
def test_the_largest_of_start_and_end_of_both_is_the_size_of_a_state(place, sign):
    """Small values count as near if they differ by little compared with the one large value."""
    values = [0.0, 0.0, 0.0, 0.0]
    values[place] = sign * 1.0
    values[(place + 2) % 4] = sign * 0.99  # the same value in the other motion
    a, b, c, d = ((v,) for v in values)
    assert near(a, b, c, d)
    # the other values differ by as much as the size allows
    values[(place + 1) % 4] = sign * 0.995 * (NEAR_END if place % 2 == 0 else NEAR_START)
    a, b, c, d = ((v,) for v in values)
    assert near(a, b, c, d)
    values[(place + 1) % 4] = sign * 1.02 * (NEAR_END if place % 2 == 0 else NEAR_START)
    a, b, c, d = ((v,) for v in values)
    assert not near(a, b, c, d)


def test_a_small_state_beside_a_large_one_is_judged_by_its_own_size():
    assert not near((1e9, 1e-3), (1e9, 1e-3), (1e9, 2e-3), (1e9, 1e-3))
    assert not near((1e-3, 1e9), (1e-3, 1e9), (2e-3, 1e9), (1e-3, 1e9))


def test_a_state_that_is_zero_in_both_is_near():
    assert near((0.0,), (0.0,), (0.0,), (0.0,))
    assert not near((0.0,), (0.0,), (math.ulp(0.0) * 100,), (0.0,))
