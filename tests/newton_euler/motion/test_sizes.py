"""Sizes of states, from their coupling to the others; what the round-off of a large time does."""

import math

import numpy as np
import pytest

from newton_euler import Model, sin, sqrt, where
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.sizes import (
    ROUND_OFF,
    TIME_SAFETY,
    _spectral_radius,
    natural_sizes,
    time_round_off,
)


def system(rates, states=("x", "v")):
    return prepared_model(Model("any", {}, states, lambda s, p, t: rates(s, t)))


def oscillator(w):
    return system(lambda s, t: (s.v, -w * w * s.x))


@pytest.mark.parametrize("w", [1e-6, 1.0, 300.0])
@pytest.mark.parametrize("unit", [1e-9, 1.0, 1e12])
def test_an_oscillator_has_the_sizes_of_its_amplitudes_in_every_unit(w, unit):
    point = 7.0, (unit, 0.0)
    natural, with_time = natural_sizes(oscillator(w), [point], (unit, w * unit), 1e9)
    assert natural == pytest.approx((unit, w * unit), rel=1e-6, abs=0.0)
    assert with_time == natural


def test_a_state_that_is_zero_is_as_large_as_the_others_make_it_within_its_domain():
    """The position starts at zero: its size is what the velocity would make of it."""
    point, w = (0.0, (0.0, 6.0)), 3.0
    natural, _ = natural_sizes(oscillator(w), [point], (0.0, 6.0), 1e9)
    assert natural[0] == pytest.approx(2.0, rel=1e-3)
    rates = system(lambda s, t: (s.v, sqrt(s.x)))
    natural, _ = natural_sizes(rates, [(0.0, (0.0, 1.0))], (1.0, 1.0), 1.0)
    assert natural[1] > 0.9


@pytest.mark.parametrize("size", [1e-9, 1e9])
def test_the_step_of_a_difference_is_small_beside_the_size_of_the_state(size):
    """v' = -sin(x/size) has slope 1/size at zero, which a fixed step of 1e-6 would not show."""
    rates = system(lambda s, t: (s.v, -sin(s.x / size)))
    points, span = [(0.0, (0.0, size**0.5))], 1e9
    known, _ = natural_sizes(rates, points, (size, size**0.5), span)
    assert known == pytest.approx((size, size**0.5), rel=1e-3, abs=0.0)
    # even where the size is not given but follows from the velocity
    found, _ = natural_sizes(rates, points, (0.0, size**0.5), span)
    assert found[0] == pytest.approx(size, rel=1e-2, abs=0.0)


class Counted:
    """A system that counts how often its rates are asked for."""

    def __init__(self, of):
        self.of, self.autonomous, self.traced, self.count = of, of.autonomous, of.traced, 0

    def rates(self, t, x):
        self.count += 1
        return self.of.rates(t, x)


@pytest.mark.parametrize(
    ("sizes", "looks"),
    [((1e-5, 1e5), 1), ((0.0, 0.0), 1), ((0.0, 0.01), 1), ((0.0, 100.0), 1),
     ((0.0, 1e-4), 2), ((0.0, 1e4), 2), ((1e-4, 0.0), 2)],
)  # fmt: skip
def test_a_second_look_is_only_for_zero_states_that_turn_out_very_small_or_large(sizes, looks):
    """One look at an oscillator takes its rates once, and once more beside each state."""
    counted = Counted(oscillator(1.0))
    natural_sizes(counted, [(0.0, sizes)], sizes, 1e9)
    assert counted.count == 3 * looks


@pytest.mark.parametrize(
    ("rates", "x", "sizes", "span", "found"),
    [
        # x' = x + v - z: 4 over the rate of the motion
        (lambda s, t: (s.x + s.v - s.z, 0.0 * s.x, 0.0 * s.x), (1.0, 1.0, 2.0), (1.0, 1.0, 2.0), 1e9, (4.0, 0.0, 0.0)),
        # v = 2 for 5 s: 10, although nothing turns or decays
        (lambda s, t: (s.v, 0.0 * s.x, 0.0 * s.x), (0.0, 2.0, 0.0), (0.0, 2.0, 0.0), 5.0, (10.0, 0.0, 0.0)),
        (lambda s, t: (sqrt(s.x), 0.0 * s.v, 0.0 * s.v), (-1.0, 0.0, 0.0), (1.0, 1.0, 1.0), 1.0, (0.0, 0.0, 0.0)),
    ],
    ids=["terms that cancel count as if they did not", "the slowest rate that counts is that of the whole time",
         "rates beyond their domain beside the point make nothing"],
)  # fmt: skip
def test_natural_sizes_are_terms_over_the_rate_of_the_motion(rates, x, sizes, span, found):
    natural, _ = natural_sizes(system(rates, ("x", "v", "z")), [(0.0, x)], sizes, span)
    assert natural == pytest.approx(found, rel=1e-3 if span > 5.0 else 1e-6)


def test_of_several_points_the_smallest_counts_and_those_without_rates_do_not():
    """The rate is v x, which changes least at the first point."""
    rates = system(lambda s, t: (s.v * s.x, 0.0 * s.x))
    points = [(0.0, (1.0, 1.0)), (1.0, (4.0, 1.0)), (2.0, (2.0, 1.0))]
    found = [natural_sizes(rates, [point], (4.0, 1.0), 0.01)[0][0] for point in points]
    assert natural_sizes(rates, points, (4.0, 1.0), 0.01)[0][0] == min(found) == found[0]
    rates = system(lambda s, t: (1 / (s.x - 1.0), 0.0 * s.v))
    assert natural_sizes(rates, [(0.0, (1.0, 0.0))], (1.0, 1.0), 1.0)[0] == (0.0, 0.0)
    one = natural_sizes(rates, [(0.0, (3.0, 0.0))], (1.0, 1.0), 1.0)
    assert one[0][0] == pytest.approx(0.25, rel=1e-4)
    assert natural_sizes(rates, [(0.0, (1.0, 0.0)), (0.0, (3.0, 0.0))], (1.0, 1.0), 1.0) == one


def test_beside_a_jump_the_slope_is_that_of_the_other_side():
    """Otherwise dry friction at rest would give the velocity the size of its jump over a step."""
    for sign in (1.0, -1.0):
        rates = system(lambda s, t, a=sign: (s.v, where(a * s.v > 0, -7.0, 7.0) - 4.0 * s.v))
        natural, _ = natural_sizes(rates, [(0.0, (1.0, 0.0))], (1.0, 1.0), 1.0)
        assert natural == pytest.approx((0.25, 1.0), rel=1e-2)


def test_the_time_counts_by_how_the_rates_change_with_it():
    """x' = 5 t changes by 5 per second, at t = 8 s: 5 times 8 s, over a rate of 1/2 s."""
    rates = system(lambda s, t: (5.0 * t, -s.v))
    natural, with_time = natural_sizes(rates, [(8.0, (1.0, 1.0))], (1.0, 3.0), 0.5)
    assert natural == pytest.approx((0.0, 1.5), rel=1e-6)
    assert with_time == pytest.approx((20.0, 1.5), rel=1e-6)
    # the largest change counts, whatever its sign
    falling = system(lambda s, t: (-5.0 * t, -s.v))
    points = [(8.0, (1.0, 1.0)), (0.0, (1.0, 1.0))]
    assert natural_sizes(falling, points, (1.0, 3.0), 0.5)[1] == pytest.approx((20, 1.5), rel=1e-6)


def test_the_change_with_time_is_taken_over_a_small_fraction_of_the_whole_time():
    """x' = sin(1e5 t) at t = 0, for a millisecond."""
    rates = system(lambda s, t: (sin(1e5 * t + 1.0), 0.0 * s.v))
    _, with_time = natural_sizes(rates, [(1.0, (1.0, 1.0))], (1.0, 1.0), 1e-3)
    exact = 1e5 * abs(math.cos(1e5 + 1.0)) * 1e-3
    assert with_time[0] == pytest.approx(exact, rel=1e-3)


@pytest.mark.parametrize(
    "matrix",
    [[[0.0, 1.0], [1.0, 0.0]], [[2.0, 0.0], [0.0, 1.0]], [[0.0, 9.0], [4.0, 0.0]], [[-1.0, 2.0], [2.0, -1.0]],
     [[1.0, 2.0, 0.5], [0.0, 3.0, 1.0], [2.0, 0.1, 1.0]]],
)  # fmt: skip
def test_the_spectral_radius_is_about_that_of_the_absolute_values(matrix):
    a = np.array(matrix)
    exact = max(abs(np.linalg.eigvals(abs(a))))
    columns = a.T.tolist()
    assert _spectral_radius(columns, [1.0] * len(a)) == pytest.approx(exact, rel=0.02)
    # other units give the same
    scale = np.array([1e6, 1.0, 1e-3])[: len(a)]
    columns = (a * scale[:, None] / scale).T.tolist()
    assert _spectral_radius(columns, scale.tolist()) == pytest.approx(exact, rel=0.02)


def test_the_spectral_radius_of_rates_that_nothing_changes_is_zero_and_of_huge_ones_huge():
    assert _spectral_radius([[0.0, 0.0], [0.0, 0.0]], [1.0, 1.0]) == 0.0
    assert _spectral_radius([[1e200, 0.0], [0.0, 1.0]], [1.0, 1.0]) >= 1e200


def test_rates_without_time_have_no_error_from_it():
    assert time_round_off(oscillator(1.0), 1e9, (1.0, 0.0), (1.0, 1.0), 1e9) == 0.0


@pytest.mark.parametrize("t", [1.0, 1e9])
def test_the_round_off_of_the_time_moves_the_phase_of_a_force(t):
    """x' = sin(w t): in one second x moves by w t round-offs, relative to its size."""
    w, size = 2.0, 0.5
    driven = system(lambda s, t: (sin(w * t), 0.0 * s.v))
    found = time_round_off(driven, t, (0.3, 1.0), (size, 1.0), 1.0)
    slope = abs(w * math.cos(w * t))
    assert found == pytest.approx(TIME_SAFETY * ROUND_OFF * slope * t / size, rel=1e-2, abs=0.0)


@pytest.mark.parametrize(
    ("rates", "x", "part"),
    [
        (lambda s, t: (2.0 * t - 9.0 * s.x, 0.0 * s.v), 1.0, 2.0 / 9.0),
        (lambda s, t: (2.0 * t, 0.0 * s.v), 0.0, 1.0),
        (lambda s, t: (0.0 * t * s.x, 0.0 * s.v), 0.0, 0.0),
        (lambda s, t: (2.0 * t, 7.0 * t), 1.0, 7.0),
    ],
    ids=["what the states make of a rate is not an error of the time",
         "of a state of no size it is relative to what it would be", "nothing", "the worst state counts"],
)  # fmt: skip
def test_the_error_from_the_time_is_its_round_off_in_the_rates(rates, x, part):
    found = time_round_off(system(rates), 1.0, (x, 1.0), (x, 1.0), 1.0)
    assert found == pytest.approx(TIME_SAFETY * ROUND_OFF * part, rel=1e-3, abs=0.0)
    assert found >= 2.0**-53 * part  # the round-off of one number
