"""The zeros of a function of time: all of them, and only those that count."""

import math

import numpy as np
import pytest
from numpy.polynomial import chebyshev as numpys

from newton_euler.motion import zeros
from newton_euler.motion.chebyshev import DEGREE, EPS


class Function:
    """A function of arrays of times, with its round-off, that counts the instants evaluated."""

    def __init__(self, f, round_off=EPS):
        self.f, self.round_off, self.count = f, round_off, 0
        self.low, self.high = -math.inf, math.inf

    def values(self, times):
        self.count += times.size
        self.check(times)
        with np.errstate(all="ignore"):
            return self.f(times)

    def check(self, times):
        """No instant lies outside the interval."""
        assert self.low <= times.min()
        assert times.max() <= self.high

    def noise(self, times):
        self.check(times)
        return np.full(len(times), self.round_off)


def search(f, a, b, sign=None, round_off=EPS, **options):
    """The zeros in order, and the function that was searched."""
    asked = f if isinstance(f, Function) else Function(f, round_off)
    asked.low, asked.high = a, b
    sign = int(np.sign(asked.f(np.array([a]))[0])) if sign is None else sign
    found, ends = [], []
    for some, end in zeros.ZeroSearch(asked.values, asked.noise, a, b, sign, **options):
        found += some
        ends.append(end)
        # every zero found so far lies in the part searched so far
        assert all(zero.t <= end for zero in found)
    assert ends == sorted(ends)
    assert ends[-1] == b
    assert found == sorted(found)
    return found


def times(*args, **options):
    return [zero.t for zero in search(*args, **options)]


# -- which zeros


@pytest.mark.parametrize("factor", [1e-200, -1.0, 1e200])
def test_the_zeros_of_a_smooth_function_are_known_to_round_off_with_their_slopes(factor):
    asked = Function(lambda t: factor * np.cos(t), EPS * abs(factor))
    found = search(asked, 0.0, 20.0)
    exact = math.pi * (np.arange(6) + 0.5)
    assert [zero.t for zero in found] == pytest.approx(exact, rel=4 * EPS, abs=0.0)
    slopes = -factor * np.sin(exact)
    assert [zero.slope for zero in found] == pytest.approx(slopes, rel=1e-5, abs=0.0)
    # 16 instants for each piece; 8 pieces would do, plus those that were halved
    assert asked.count < 16 * 15 + 6 * 5 + 12


@pytest.mark.parametrize("shift", [-1e-9, 1e-9])
@pytest.mark.parametrize(
    ("f", "half", "round_off", "off"),
    [
        (lambda x: x * x, math.sqrt(1e-9), EPS, 1e-11),
        # the polynomial is less accurate for this function
        (lambda x: np.expm1(x) - x, math.sqrt(2e-9), 1e-16, 1e-8),
    ],
)
def test_no_zero_is_missed_where_two_lie_close_together(f, half, round_off, off, shift):
    found = times(lambda t: f(t - 5.0) + shift, 0.0, 9.0, round_off=round_off)
    assert found == pytest.approx([5.0 - half, 5.0 + half] if shift < 0 else [], abs=off)


@pytest.mark.parametrize("factor", [1.0, -1e-200, 1e200])
def test_a_function_that_only_touches_zero_has_none(factor):
    for c in np.linspace(1.0, 8.0, 40):
        # the second form has negative round-off for some c
        assert times(lambda t, c=c: factor * (t - c) ** 2, 0.0, 9.0, round_off=0.0) == []
        f = lambda t, c=c: factor * (t * t - 2 * c * t + c * c)
        assert times(f, 0.0, 9.0, round_off=1e-13 * abs(factor)) == []
    assert times(lambda t: np.abs(t - 5.0), 0.0, 9.0, round_off=1e-15) == []


@pytest.mark.parametrize(("direction", "numbers"), [(0, [0, 1, 2]), (1, [1]), (-1, [0, 2])])
def test_only_zeros_of_the_direction_count(direction, numbers):
    exact = [math.pi * (n + 0.5) for n in numbers]
    assert times(np.cos, 0.0, 9.0, direction=direction) == pytest.approx(exact)


def test_the_sign_before_the_interval_counts_at_its_beginning_and_goes_on_to_the_end():
    for sign, exact in ((1, []), (0, []), (-1, [0.0])):
        assert times(lambda t: t + 1.0, 0.0, 1.0, sign=sign) == pytest.approx(exact, abs=EPS)
    asked = Function(np.cos)
    one = zeros.ZeroSearch(asked.values, asked.noise, 0.0, 3.0, 1)
    assert len([zero for some, _ in one for zero in some]) == 1
    assert one.sign == -1


@pytest.mark.parametrize("value", [0.0, 1e-17, -1e-17])
@pytest.mark.parametrize("is_zero", [True, False])
def test_a_zero_at_the_start_does_not_count_despite_round_off(value, is_zero):
    for f in (np.sin, lambda t: -np.sin(t)):
        found = times(f, 0.0, 4.0, sign=int(np.sign(value)), start=(value, is_zero))
        assert found == pytest.approx([math.pi])


def test_a_value_at_the_start_that_is_not_round_off_has_its_sign():
    """The start lies just before the zero, so the event happens at once."""
    just_after = lambda t: t - 1e-12
    assert times(just_after, 0.0, 4.0, start=(-1e-12, False)) == pytest.approx([1e-12])
    f = lambda t: (t - 1.0) - 1e-12
    assert times(f, 1.0, 4.0, start=(-1e-12, False), round_off=0.0) == pytest.approx([1.0 + 1e-12])
    # what is left of an event that has just happened is not a second event
    assert times(just_after, 0.0, 4.0, start=(-1e-12, True)) == []
    assert times(lambda t: t - 1e-6, 0.0, 4.0, start=(-1e-6, True)) == pytest.approx([1e-6])


@pytest.mark.parametrize("factor", [1e-6, 1.0, 1e6])
def test_at_the_start_the_time_is_round_off_too(factor):
    """sin(pi) is not zero in floats, but the float pi is not exactly pi either."""
    start = factor * math.sin(math.pi), False
    assert times(lambda t: factor * np.sin(t), math.pi, 5.0, start=start, round_off=0.0) == []
    # by the slope at the start
    f, start = lambda t: -factor * np.expm1(-20.0 * (t - 3.0)), (-factor * 2e-14, False)
    assert times(f, 3.0, 5.0, sign=-1, start=start, round_off=0.0) == []


@pytest.mark.parametrize("factor", [1.0, -1.0])
def test_a_zero_at_the_end_counts_where_the_motion_ends(factor):
    f = lambda t: factor * np.sin(t)
    assert times(f, 1.0, math.pi, closed=True) == [math.pi]
    assert times(f, 1.0, math.pi) == []
    assert times(f, 1.0, 3.14, closed=True) == []
    assert times(lambda t: factor * (t - 2.0) ** 2, 1.0, 2.0, closed=True) == []


@pytest.mark.parametrize("part", [1e-6, 3e-5, 6e-5, 1.0])
def test_a_zero_at_the_end_is_found_there_however_slowly_the_function_goes_through_it(part):
    """A search that mistook the zero for a touch would miss it."""
    exact = [] if part == 1e-6 else [3.0]  # it cannot be told from a touch
    f = lambda t: (t - 3.0) * (part * 9.0 + (t - 3.0) ** 2)
    assert times(f, 0.0, 3.0, closed=True) == exact


@pytest.mark.parametrize("place", [0.5, 3.7, math.e])
@pytest.mark.parametrize("factor", [1e-100, -1.0, 1e100])
def test_at_a_jump_the_sign_changes_within_a_float(place, factor):
    f = lambda t: factor * np.where(t > place, 1.0, -7.0)
    (zero,) = search(f, 0.0, 5.0, round_off=EPS * abs(factor))
    assert zero.t == pytest.approx(place, rel=2 * EPS, abs=0.0)
    assert zero.slope == 0.0


def test_kinks_have_zeros_on_each_side_and_poles_and_round_off_none():
    found = times(lambda t: np.abs(t - 2.0) - 1e-5, 0.0, 5.0, round_off=1e-15)
    assert found == pytest.approx([2.0 - 1e-5, 2.0 + 1e-5], abs=1e-13)
    assert times(np.tan, 0.1, 9.0) == pytest.approx([math.pi, 2 * math.pi])
    for place in (0.0, 3.0):
        assert times(lambda t, place=place: 1 / (t - place), place - 3.0, place + 2.0) == []
    # values that jump between plus and minus 1e-17, beside 1
    wild = lambda t: 1e-17 * np.where(np.sin(1e9 * t) > 0, 1.0, -1.0)
    assert times(wild, 0.0, 5.0, sign=0, round_off=1e-16) == []


@pytest.mark.parametrize("frequency", [60.0, 1000.0])
def test_a_fast_oscillation_is_not_taken_for_a_slow_one(frequency):
    found = times(lambda t: np.cos(frequency * t), 0.0, 3.0)
    exact = math.pi * (np.arange(round(frequency * 3.0 / math.pi)) + 0.5) / frequency
    assert found == pytest.approx(exact)


@pytest.mark.parametrize("alone", range(3))
def test_each_check_point_alone_shows_an_oscillation_that_vanishes_at_all_other_points(alone):
    """1 - c w(x), where w is zero at all Chebyshev and check points but one: 15 of the 16 values
    are 1.
    """
    hidden = [x for n, x in enumerate((-0.8617, -0.2913, 0.4477)) if n != alone]

    def f(t):
        x = 2.0 * t - 1.0
        at_chebyshev_points = (1 - x * x) * numpys.chebval(x, numpys.chebder([0.0] * 12 + [1.0]))
        return 1.0 - 5.0 * at_chebyshev_points * (x - hidden[0]) * (x - hidden[1])

    fine = np.sign(f(np.linspace(0.0, 1.0, 100_001)))
    changes = np.count_nonzero(np.diff(fine))
    assert changes > 5
    assert len(times(f, 0.0, 1.0)) == changes


@pytest.mark.parametrize("foot", [0.9, 1.3, 2.0])
def test_a_peak_whose_foot_only_the_end_of_a_step_sees_is_resolved(foot):
    """The zeros are where exp(-u^2) is one half; ``foot`` is |u| at the end of the step."""
    half = math.sqrt(math.log(2))
    for w in (1e-4, 1e-3, 4e-3, 1e-2, 3e-2, 0.1):
        found = times(lambda t, w=w: np.exp(-((t / w - foot) ** 2)) - 0.5, 0.0, 1.0)
        assert found == pytest.approx([w * (foot - half), w * (foot + half)])


def test_a_rough_function_that_stays_away_from_zero_is_looked_at_once():
    asked = Function(lambda t: 5.0 + np.abs(np.sin(37.0 * t)))
    assert times(asked, 0.0, 5.0) == []
    assert asked.count == DEGREE + 1 + len(zeros.CHECKS)


@pytest.mark.parametrize("late", [2.0**32, -(2.0**32)])
def test_at_late_times_a_smooth_function_is_as_smooth_though_its_times_are_rounded(late):
    asked = Function(lambda t: np.cos(t - late), 1e-6)
    found = times(asked, late, late + 20.0)
    assert found == pytest.approx(late + math.pi * (np.arange(6) + 0.5), rel=EPS, abs=0.0)
    assert asked.count < 300


@pytest.mark.parametrize(("depth", "count"), [(7e-13, 0), (9e-13, 2)])
def test_round_off_may_be_eight_times_what_is_measured_at_a_few_points(depth, count):
    assert len(times(lambda t: (t - 5.0) ** 2 - depth, 0.0, 9.0, round_off=1e-13)) == count


def test_a_part_without_values_is_an_error_that_names_it():
    with pytest.raises(zeros.VoidError, match="no value from t = 3 to 3; give one"):
        times(lambda t: np.sqrt(3.0 - t) + 1.0, 0.0, 5.0)


def piece(left, right, c):
    one = zeros.Piece(left, right)
    one.fit, one.state = np.zeros(DEGREE + 4), "smooth"
    one.fit[: len(c)] = c
    return one


def test_places_and_slopes_of_a_piece_are_in_time():
    one = piece(2.0, 6.0, [0.3, -1.0, 2.0])
    assert [one.time(x) for x in (-1, -0.5, 1)] == [2.0, 3.0, 6.0]
    slopes = numpys.chebval([-1, 1], numpys.chebder([0.3, -1.0, 2.0])) / 2.0
    assert [one.slope(-1), one.slope(1)] == pytest.approx(slopes)


@pytest.mark.parametrize("sign", [1, -1])
def test_the_guess_is_the_zero_of_the_polynomial_or_the_nearer_end(sign):
    one = piece(0.0, 1.0, [-0.3 * sign, 1.0 * sign])  # zero at 0.3
    assert zeros._guess(zeros.Bracket(one, -0.5, 0.8, sign)) == pytest.approx(0.3)
    assert zeros._guess(zeros.Bracket(one, 0.5, 0.8, sign)) == 0.5
    assert zeros._guess(zeros.Bracket(one, -0.5, 0.1, sign)) == 0.1
    one.state = "rough"
    assert zeros._guess(zeros.Bracket(one, -0.5, 0.8, sign)) == -0.5
