"""Heyoka's series: its levels of accuracy, the integrators that are kept, and each way in which
a run reaches its goal.
"""

import math

import numpy as np
import pytest

from newton_euler import Model, sin
from newton_euler.motion import prepare, second_order
from newton_euler.motion.methods import taylor
from newton_euler.motion.methods.base import LengthError, StepError
from newton_euler.motion.prepared import PreparedModel, prepared_model
from tests.models import FALL, SPRING, begun

pytest.importorskip("heyoka")


UNKNOWN = Model("unknown", {}, ("r",), lambda s, p, t: (1 / s.r - 1 / s.r**3,))
# pairs (begin, end) for which begin + (end - begin) is not end in floats
ROUNDED = [(-0.9, 0.3), (-2.0, 0.7), (-3.9, -1.8), (-3.6, -1.2)]


def swing(t, size=1.0):
    return size * np.array([np.cos(2 * t), -2 * np.sin(2 * t)])


def series(t1=5.0, size=1.0, model=SPRING, start=None, **options):
    """A run that has not begun; by default the spring starts at rest."""
    start = start or (size, 0.0)
    usual = {"tolerance": taylor.LEVELS[-1], "units": (size,) * len(start)}
    return begun(taylor.Taylor, prepared_model(model), start, t1, **usual | options)


# -- levels and integrators


def test_the_level_of_a_tolerance_is_the_next_below():
    assert taylor.level_of(1.0) == taylor.LEVELS[0]
    assert taylor.level_of(taylor.LEVELS[3]) == taylor.LEVELS[3]
    assert taylor.level_of(0.999 * taylor.LEVELS[3]) == taylor.LEVELS[4]
    assert taylor.level_of(0.0) == taylor.LEVELS[-1] == pytest.approx(2.0**-52, rel=0.05)


@pytest.mark.parametrize("n", [0, 8, 16])
def test_a_level_is_where_heyoka_takes_another_order(n):
    system = prepared_model(SPRING)
    orders = [
        taylor._made(system, part * taylor.LEVELS[n], False, None).order for part in (1.0, 0.999999)
    ]
    assert orders == [n + 3, n + 4]


@pytest.mark.parametrize(("x", "found"), [(1.0, 1.0), (3.9, 2.0), (0.3, 0.25), (0.0, 1.0)])
def test_scales_are_powers_of_two(x, found):
    assert taylor._power_of_two(x) == found


def test_an_integrator_has_one_user_at_a_time_and_the_oldest_of_many_is_dropped():
    system = PreparedModel(second_order("own", {}, ("x",), lambda s, p, t: (-17 * s.x,)))
    with taylor.integrator(system, 1e-9) as one, taylor.integrator(system, 1e-9) as other:
        assert other is not one
    with taylor.integrator(system, 0.99e-9) as again, taylor.integrator(system, 1e-12) as finer:
        assert again is one or again is other
        assert finer.order > again.order
    assert len(system.traced.integrators) == 2
    system = PreparedModel(second_order("own", {}, ("x",), lambda s, p, t: (-19 * s.x,)))
    known = system.traced.integrators
    known.update({n: [] for n in range(taylor.MAX_KINDS - 1)})
    with taylor.integrator(system, 1e-9):
        assert list(known)[:2] == [0, 1]
    with taylor.integrator(system, 1e-12):
        assert list(known)[:2] == [1, 2]


@pytest.mark.parametrize(
    ("sizes", "units"),
    [
        ((1.0, 1.0), ()),
        ((0.25, 0.25), ()),
        ((0.24, 0.24), [0.125] * 2),
        ((7.9, 7.9), ()),
        ((8.0, 8.0), [8.0] * 2),
        ((0.0, 0.0), ()),
        ((1.0, 1e-3), [1.0, 2.0**-10]),
    ],
)
def test_there_are_units_if_one_state_is_small_or_large(sizes, units):
    assert series(units=sizes).units == units


# -- the ways to the goal

WAYS = {
    "at once": {},
    "by samples": {"samples": 7},
    "by samples that end before": {"samples": [1.0, 2.0]},
    "by samples without order": {"samples": [2.0, 1.0]},
    "by no samples": {"samples": []},
    "by stops": {"stops": (1.0, 2.5)},
}


@pytest.mark.parametrize("size", [1.0, 1e-6, 1e9])
@pytest.mark.parametrize("way", WAYS)
def test_each_way_to_the_goal_is_the_same_motion(way, size):
    one = series(size=size, **WAYS[way])
    one.step()
    assert one.t == 5.0
    assert one.step_times == [0.0, 5.0]
    assert one.x == pytest.approx(swing(5.0, size), abs=1e-14 * size)
    # the scales come from the ends of steps, or from samples
    assert one.scales[0] == pytest.approx(size, rel=1e-14)
    assert one.calls > 100
    for times in ([0.0, 0.3, 3.0], [3.0, 0.3], [3.0], [1.0, 2.0], [0.5, 4.0], np.linspace(0, 5, 7)):
        assert abs(one.states(times) - swing(np.array(times), size)).max() < 1e-14 * size
    assert one.state_at(3.0) == pytest.approx(swing(3.0, size), abs=1e-14 * size)


@pytest.mark.parametrize("size", [1.0, 1e-6])
def test_steps_are_kept_if_they_are_limited(size):
    one = series(size=size)
    one.step(3)
    assert len(one.step_times) == 4
    assert len(one.series) == 3
    assert one.calls == 3 * one.series[0].shape[1] - 3
    one.step(2)
    assert one.step_times == sorted(set(one.step_times))
    assert len(one.step_times) == 6
    assert one.x == pytest.approx(swing(one.t, size), abs=1e-14 * size)
    one.step(1000)
    assert one.t == one.step_times[-1] == 5.0
    assert one.scales == pytest.approx((size, 2 * size), rel=0.2)


@pytest.mark.parametrize("k", [4.0, 4e6])
def test_many_steps_are_made_in_parts(monkeypatch, k):
    """No step is made twice, as steps are where the motion makes no progress."""
    monkeypatch.setattr(taylor, "MAX_STALLED_STEPS", 3)
    w = math.sqrt(k)
    one = series(t1=10.0 / w, model=SPRING.changed(k=k))
    one.step()
    assert one.step_times == [0.0, 10.0 / w]
    assert one.x[0] == pytest.approx(math.cos(10.0), abs=1e-13)
    # the states are looked at after each part
    assert one.scales[1] > 0.5 * w


def test_a_motion_with_ever_shorter_steps_or_far_too_many_is_refused_on_the_way(monkeypatch):
    wild = Model("wild", {}, ("x",), lambda s, p, t: (sin(1 / (1 - t)),))
    one = series(2.0, model=wild, start=(1.0,))
    with pytest.raises(StepError, match="2000 steps took only"):
        one.step()
    assert 0.99 < one.t < 1.0
    monkeypatch.setattr(taylor, "MAX_STALLED_STEPS", 10)
    with pytest.raises(LengthError):
        series(t1=1e6, max_steps=1e4).step()


def test_what_was_sampled_is_kept_unless_there_are_stops():
    one = series(samples=7, stops=(1.0,))
    one.step()
    assert one.kept is None
    one = series(samples=7)
    one.step()
    calls, found = one.calls, one.states(np.linspace(0, 5, 7))
    found[:] = 0.0  # it is a copy
    assert one.states(np.linspace(0, 5, 7))[0, 0] == 1.0
    assert one.calls == calls


@pytest.mark.parametrize(("t0", "t1"), ROUNDED)
def test_a_step_to_an_end_ends_there_though_the_time_is_rounded(t0, t1):
    assert t0 + (t1 - t0) != t1
    still = Model("still", {}, ("x", "y"), lambda s, p, t: (0.0 * s.x, 0.0 * s.y))
    one = series(t1, model=still, t0=t0)
    one.step(2)
    assert one.step_times == [t0, t1]


@pytest.mark.parametrize(("stops", "steps"), [((), False), ((1.0,), True)])
def test_states_at_increasing_times_need_no_steps_unless_there_are_stops(stops, steps):
    one = series(stops=stops)
    assert one.states([0.0, 0.0]).tolist() == [[1.0, 1.0], [0.0, 0.0]]  # before the first step
    one.step()
    one.states([1.0, 2.0])
    assert (("dense" in vars(one)), one.series) == (steps, [])


@pytest.mark.parametrize("samples", [63, 100, 1000])
def test_samples_all_over_the_motion_count_for_the_scales(samples):
    one = series(t1=math.pi / 2, samples=samples)
    one.step()
    assert one.scales == pytest.approx((1.0, 2.0), abs=1e-2)


def test_a_series_that_is_not_finite_where_it_begins_is_left_to_another_method():
    """Heyoka has no series of x**8 at x = 0: it stops at once, and went on for ever in a grid."""
    model = Model("power", {"u": 1.0}, ("x", "q"), lambda s, p, t: (p.u, 9 * s.x**8))
    assert prepare(model, 1e-3)(1.0, (0.0, 0.0))[1] == pytest.approx(1.0, rel=1e-3)


@pytest.mark.parametrize("options", [{}, {"samples": 5}])
def test_where_a_series_ends_is_reported_and_what_came_before_is_kept(options):
    one = series(1.0, model=FALL, start=(1.0,), **options)
    with pytest.raises(StepError):
        one.step()
    assert one.t == pytest.approx(0.5, abs=1e-9)
    assert one.states([0.3])[0] == pytest.approx([math.sqrt(0.4)], abs=1e-14)


# -- how far the series is from the rates


def test_the_series_of_smooth_rates_is_their_motion():
    one = series()
    one.step(1000)
    assert 0.0 < one.residual() < 1e-13


@pytest.mark.parametrize("n", [0, 3])
def test_a_series_of_other_rates_is_as_far_off_as_they_are(n):
    """Relative to the largest size, and over the length of the step."""
    one = series(size=1e-6)
    one.step(1000)
    one.series[n][1, 1] += 1e-9
    length = one.step_times[n + 1] - one.step_times[n]
    apart = one.residual() * one.scales[1]
    # the velocity is wrong by 1e-9 t as well, which adds to the error of the position
    assert apart == pytest.approx(1e-9 * length, rel=0.05)


def test_the_rates_of_a_single_step_are_compared_at_many_instants():
    """The step is a hundred times as long as a bump within it."""
    bump = lambda s, p, t: (s.x, p.h / (1 + ((t - 0.5) / 0.01) ** 4))
    one = series(1.0, model=Model("bump", {"h": 1.0}, ("y", "x"), bump), start=(0.0, 1.0))
    one.series, one.step_times = [np.array([[0.0, 1.0], [1.0, 0.0]])], [0.0, 1.0]
    exact = 0.01 * math.pi / math.sqrt(2)  # the integral of 1/(1 + u^4)
    assert one.residual() == pytest.approx(exact, rel=0.05)


@pytest.mark.parametrize("model", [FALL, UNKNOWN])
def test_a_series_whose_rates_have_no_value_is_infinitely_far_off(model):
    one = series(1.0, model=model, start=(1.0,))
    one.series, one.step_times = [np.array([[1.0, -1.0]])], [0.0, 0.5]
    assert one.residual() < math.inf
    one.series = [np.array([[0.0, 0.0]])]
    assert one.residual() == math.inf


# -- prepared runs


def prepared(model=SPRING):
    return taylor.Taylor.fast_run(PreparedModel(model), 1e-12)


def test_a_prepared_series_is_the_motion_for_any_parameters():
    for k in (4.0, 9.0, 4.0):
        found = prepared(SPRING.changed(k=k))(5.0, (1.0, 0.0))
        assert found[0] == pytest.approx(math.cos(math.sqrt(k) * 5.0), abs=1e-11)


@pytest.mark.parametrize(
    ("model", "t", "start"),
    [(SPRING, 5.0, (1.0,)), (SPRING, 5.0, (1.0, math.nan)), (FALL, 1.0, (1.0,))],
    ids=["too few", "nan", "singular"],
)
def test_a_prepared_series_that_does_not_reach_its_end_has_none(model, t, start):
    assert prepared(model)(t, start) is None


def test_a_prepared_series_that_needs_too_many_steps_is_left_to_integration(monkeypatch):
    monkeypatch.setattr(taylor, "MAX_PREPARED_STEPS", 3)
    assert prepared()(50.0, (1.0, 0.0)) is not None
    monkeypatch.setattr(taylor.Taylor, "most_steps", 6)
    assert prepared()(50.0, (1.0, 0.0)) is None


@pytest.mark.parametrize("samples", [None, 9])
def test_as_many_steps_are_needed_as_the_first_ones_show_however_sampled(monkeypatch, samples):
    monkeypatch.setattr(taylor, "MAX_STALLED_STEPS", 10)
    one = series(400.0, samples=samples)
    one.step()
    assert np.array(one.x) == pytest.approx(swing(400.0), abs=1e-12)
    most = one.calls / 19
    assert 100 < most < 2000
    assert one.states([123.0, 321.0]) == pytest.approx(swing(np.array([123.0, 321.0])), abs=1e-12)
    series(400.0, samples=samples, max_steps=1.2 * most).step()
    with pytest.raises(LengthError):
        series(400.0, samples=samples, max_steps=0.8 * most).step()


def test_the_steps_of_a_long_motion_are_not_kept_for_the_state_at_one_instant(monkeypatch):
    monkeypatch.setattr(taylor, "FEW_STEPS", 10)
    one = series(50.0)
    one.step()
    assert one.states([12.0])[:, 0] == pytest.approx(swing(12.0), abs=1e-12)
    assert "dense" not in vars(one)
