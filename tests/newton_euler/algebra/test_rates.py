"""Unknown rates from conditions that must vanish."""

import numpy as np
import pytest

from newton_euler import (
    sin,
    solve_rates,
)
from newton_euler.algebra import FrameError, ScalarError
from tests.kinds import KINDS, close, first, numbers


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("surplus", [0, 2])
def test_solve_rates_finds_one_two_and_three_rates_also_from_agreeing_surplus_conditions(
    kind, count, surplus
):
    m = [[2, 1, -1], [1, 3, "1/2"], [-1, 1, 4], [3, 4, "-1/2"], [1, 2, 7]]
    wanted = numbers(kind, "1/3", -2, "7/5")[:count]
    rows = [[numbers(kind, m[a][b]) for b in range(count)] for a in range(count + surplus)]
    right = [sum(c * w for c, w in zip(row, wanted, strict=True)) for row in rows]

    def conditions(*rates):
        return tuple(
            sum((c * r for c, r in zip(row, rates, strict=True)), start=0) - b
            for row, b in zip(rows, right, strict=True)
        )

    assert close(solve_rates(conditions, count), wanted, 1e-11)


@pytest.mark.parametrize("kind", KINDS)
def test_solve_rates_says_that_conditions_contradict_each_other(kind):
    one, two = numbers(kind, 1, 2)
    with pytest.raises(
        FrameError,
        match=r"contradict each other: with the rates that fit best, one of them is 0\.5 instead "
        r"of 0",
    ):
        solve_rates(lambda w: (w - first(one), w - first(two)), 1)


@pytest.mark.parametrize("kind", KINDS)
def test_solve_rates_says_that_rates_are_left_open(kind):
    one = numbers(kind, 1)
    with pytest.raises(
        FrameError,
        match="1 conditions contain the rates, but 2 rates are unknown: 1 more are needed",
    ):
        solve_rates(lambda w, u: one * w + u - one, 2)
    with pytest.raises(FrameError, match="the conditions do not determine the rates"):
        solve_rates(lambda w, u: (one * w + u - one, 2 * w * one + 2 * u - one), 2)
    with pytest.raises(FrameError, match="the conditions do not determine the rates"):
        solve_rates(lambda w, u: (one * w - one, 3 * one * w - one), 2)


def test_solve_rates_says_so_if_one_instant_of_many_is_singular():
    lever = np.array([1.0, 0.0, 2.0])
    with pytest.raises(FrameError, match="do not determine"):
        solve_rates(lambda w: lever * w - 1.0, 1)


def test_solve_rates_refuses_what_is_not_linear():
    for conditions in (
        lambda w: w * w - 4.0,
        lambda w: sin(w) - 0.5,
        lambda w: 1 / w - 2.0,
        lambda w: w**2 - 1,
    ):
        with pytest.raises(ScalarError, match="must be linear in"):
            solve_rates(conditions, 1)
