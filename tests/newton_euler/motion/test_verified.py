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


@pytest.mark.parametrize(
    ("error", "asked", "covered"),
    [
        # the same run, even if it is only just as accurate as asked
        (RTOL, (RTOL, 0.0, 10.0, START, END), True),
        # another rtol or time
        (0.0, (1e-10, 0.0, 10.0, START, END), False),
        (0.0, (1e-8, 0.0, 10.0, START, END), False),
        (0.0, (RTOL, 0.1, 10.0, START, END), False),
        (0.0, (RTOL, 0.0, 9.9, START, END), False),
        # beside it, or from the same start with other steps, with something to spare or not
        (RTOL / SPARE, (RTOL, 0.0, 10.0, BESIDE, BESIDE_END), True),
        (1.01 * RTOL / SPARE, (RTOL, 0.0, 10.0, BESIDE, BESIDE_END), False),
        (RTOL / SPARE, (RTOL, 0.0, 10.0, START, BESIDE_END), True),
        (1.01 * RTOL / SPARE, (RTOL, 0.0, 10.0, START, BESIDE_END), False),
        # far from it
        (0.0, (RTOL, 0.0, 10.0, (2.0, 2.0), END), False),
        (0.0, (RTOL, 0.0, 10.0, BESIDE, (3.0, 4.0)), False),
    ],
)
def test_a_verified_run_covers_itself_and_those_beside_it(error, asked, covered):
    assert verified(error).covers(*asked) is covered
    assert not Verified().covers(*asked)


def test_the_last_run_of_each_rtol_counts():
    runs = verified(0.0)
    runs.add(1e-6, 0.0, 10.0, START, END, 0.0)
    runs.add(RTOL, 0.0, 5.0, START, END, 0.0)
    assert not runs.covers(RTOL, 0.0, 10.0, START, END)
    assert runs.covers(RTOL, 0.0, 5.0, START, END)
    assert runs.covers(1e-6, 0.0, 10.0, START, END)


@pytest.mark.parametrize("size", [1e-150, -1.0, 1e150])
@pytest.mark.parametrize("place", range(4))
@pytest.mark.parametrize(("part", "found"), [(0.995, True), (1.02, False)])
def test_the_largest_of_start_and_end_of_both_is_the_size_of_a_state(place, size, part, found):
    values = [0.0, 0.0, 0.0, 0.0]
    values[place] = size
    values[(place + 2) % 4] = 0.99 * size  # the same value in the other motion
    # the other values differ by as much as the size allows, or by a little more
    values[(place + 1) % 4] = part * size * (NEAR_END if place % 2 == 0 else NEAR_START)
    assert near(*((x,) for x in values)) is found


@pytest.mark.parametrize(
    ("start", "other", "found"),
    [
        ((1e9, 1e-3), (1e9, 2e-3), False),  # a small state is judged by its own size
        ((1e-3, 1e9), (2e-3, 1e9), False),
        ((0.0, 1.0), (0.0, 1.0), True),
        ((0.0, 1.0), (100 * math.ulp(0.0), 1.0), False),
    ],
)
def test_every_state_must_be_near(start, other, found):
    assert near(start, start, other, start) is found
