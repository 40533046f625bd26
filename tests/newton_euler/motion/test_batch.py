"""Many motions at once: which motions vouch for which, and that each is as accurate as asked."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from newton_euler import Model, cos, exp, integrate, sin
from newton_euler.motion import AccuracyError, Event, ModelError, batch, second_order
from newton_euler.motion.batch import MIN_HEYOKA_BATCH, _by_series, _clock_errors, _representatives
from newton_euler.motion.error_estimates import ROUND_OFF_OF_RATES
from newton_euler.motion.methods.taylor import batches
from newton_euler.motion.prepared import PreparedModel, prepared_model
from newton_euler.motion.sizes import time_round_off
from newton_euler.motion.verified import NEAR_END, NEAR_START, SPARE
from tests.models import FALL, needs_heyoka, oscillator

START = (1.0, 0.0)
PENDULUM = second_order("pendulum", {"n": 1.0}, ("a",), lambda s, p, t: (-p.n * sin(s.a),))
SPRING = oscillator().changed(k=1.0)


def test_motions_close_to_each_other_have_one_representative_and_others_themselves():
    """Two clusters of starts and ends, of 20 motions each, in turn."""
    begins = np.array([[1.0, 2.0] * 20, [1e-6, 1e-6] * 20]) * np.linspace(1.0, 1.01, 40)
    ends = np.array([[5.0, -5.0] * 20]) * np.linspace(1.0, 1.01, 40)
    chosen, group = _representatives(begins, ends)
    assert [n % 2 for n in chosen] == [0, 1]
    assert group.tolist() == [0, 1] * 20
    begins = np.random.default_rng(0).uniform(-1.0, 1.0, (6, 300))
    chosen, group = _representatives(begins, begins)
    assert chosen.tolist() == group.tolist() == list(range(300))


def test_many_motions_are_known_at_their_samples():
    found = integrate(oscillator(), 2.0, (np.array([1.0, 2.0]), 0.0), samples=[0.5, 2.0])
    assert found.at(0.5)["x"] == pytest.approx(math.cos(1.0) * np.array([1.0, 2.0]), rel=1e-8)
    assert (found.at(2)["dx"] == found.end["dx"]).all()
    for bad in (0.7, [0.5, 2.0], np.ma.array([0.5], mask=[1])):
        with pytest.raises(ModelError, match="known at their times alone"):
            found.at(bad)


@pytest.mark.parametrize(("part", "which", "count"), [
    (0.99 * NEAR_START, "begins", 1),
    (1.01 * NEAR_START, "begins", 2),
    (0.99 * NEAR_END, "ends", 1),
    (1.01 * NEAR_END, "ends", 2),
])  # fmt: skip
@pytest.mark.parametrize("sign", [1, -1])
def test_closeness_is_relative_to_the_size(part, which, count, sign):
    values = {"begins": np.full((2, 12), sign * 7.0), "ends": np.full((2, 12), sign * 7.0)}
    values[which][1, 5] *= 1 - part
    chosen, group = _representatives(values["begins"], values["ends"])
    assert len(chosen) == count
    assert np.count_nonzero(group == group[5]) == (12 if count == 1 else 1)


@pytest.mark.parametrize("shuffled", [False, True])
def test_a_sweep_has_a_representative_for_all_within_2_percent_in_any_order(shuffled):
    sweep = np.geomspace(1.0, 1.5, 1000)
    if shuffled:
        sweep = np.random.default_rng(0).permutation(sweep)
    chosen, group = _representatives(sweep[None], np.ones((1, 1000)))
    apart = abs(sweep - sweep[chosen][group]) / np.maximum(sweep, sweep[chosen][group])
    assert apart.max() <= NEAR_START
    assert len(chosen) <= 2 * np.log(1.5) / (2 * NEAR_START)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_motions_without_a_finite_end_represent_no_others(bad):
    ends = np.ones((2, 30))
    ends[1, ::3] = bad
    assert together(np.ones((2, 30)), ends) == [n if n % 3 == 0 else 1 for n in range(30)]


def together(begins, ends):
    """For each motion, the lowest number among the motions that share its representative."""
    _, group = _representatives(begins, ends)
    _, first = np.unique(group, return_index=True)
    return first[group].tolist()


@pytest.mark.parametrize(("part", "number"), [(0.99, 0), (1.01, 5)])
def test_a_motion_that_is_smaller_as_a_whole_is_judged_by_the_size_of_the_larger(part, number):
    both = np.full((1, 12), 7.0)
    both[0, 5] *= 1 - part * NEAR_START
    assert together(both, both)[5] == together(1 / both, 1 / both)[5] == number


def test_the_size_of_a_state_is_that_of_its_end_whichever_way_it_points():
    begins, ends = np.full((1, 20), 1e-3), -5.0 * np.linspace(1.0, 1.01, 20)[None]
    assert together(begins, ends) == [0] * 20


def test_a_state_that_is_zero_at_both_ends_is_judged_by_the_others_as_far_as_it_is_like_them():
    """The second state ends at 0 or 1e-8, and once at 1e-7. From number 10 on the first state is a
    thousandth of what it was before, so that 1e-8 is not small beside it. The third state is
    always zero.
    """
    begins, ends = np.zeros((3, 20)), np.zeros((3, 20))
    begins[0] = ends[0] = [1e-6] * 10 + [1e-9] * 10
    ends[1] = [0.0, 1e-8] * 10
    ends[1, 9] = 1e-7
    # whichever motion stands in the middle of a block, states that are not small do not join it
    assert together(begins, ends) == [0] * 9 + [9] + [10, 11] * 5


@pytest.mark.parametrize(("ends", "groups"), [([1.0, 0.0, 0.15], [0, 1, 1]), ([1.0, 0.7], [0, 1])])
def test_motions_that_all_begin_at_zero_are_judged_by_the_largest_end(ends, groups):
    assert together(np.zeros((1, 7 * len(ends))), np.array([7 * ends])) == 7 * groups


@needs_heyoka
@pytest.mark.parametrize(
    ("method", "count", "hazards", "found"),
    [
        ("auto", MIN_HEYOKA_BATCH - 1, (), False),
        ("auto", MIN_HEYOKA_BATCH, (), True),
        ("taylor", 1, (), True),
        ("dop853", 10 * MIN_HEYOKA_BATCH, (), False),
        ("exact", 10 * MIN_HEYOKA_BATCH, (), False),
        ("taylor", 100, ("sqrt",), False),
        ("auto", 100, ("sqrt",), False),
    ],
)
def test_heyoka_is_taken_if_asked_or_worth_it_and_a_series_sees_all(method, count, hazards, found):
    traced = SimpleNamespace(hazards=hazards, kinks=(), inner=())
    assert _by_series(SimpleNamespace(traced=traced), method, count) is found


@needs_heyoka
def test_auto_takes_no_batch_of_series_for_rates_with_kinks():
    traced = SimpleNamespace(hazards=(), kinks=("where",), inner=())
    kinked = SimpleNamespace(traced=traced, model=SimpleNamespace(name="any"))
    assert not _by_series(kinked, "auto", 100)


def amplitudes(count):
    return np.linspace(0.1, 2.0, count)


@needs_heyoka
@pytest.mark.parametrize("count", [1, 3, 65])
@pytest.mark.parametrize(
    "samples", [None, 7, [2.0, 5.0], [0.0, 2.0, 5.0], [5.0], [0.0, 5.0]], ids=str
)
def test_each_motion_of_a_batch_is_that_of_integrate_at_its_samples(count, samples):
    a = amplitudes(count)
    motions = integrate(PENDULUM, 5.0, (a, 0.0 * a), method="taylor", samples=samples)
    assert len(motions) == count
    assert motions.states["a"].shape == (count, len(motions.times))
    assert motions.method.name == "taylor"
    assert motions.cost.calls > 0
    assert (motions.error <= 1e-9).all()
    for n in {0, count // 2, count - 1}:
        one = integrate(PENDULUM, 5.0, (a[n], 0.0), 1e-11)
        for name in ("a", "da"):
            assert abs(motions.states[name][n] - one.at(motions.times)[name]).max() <= 2e-9


@needs_heyoka
@pytest.mark.parametrize("t", [(2.0, 6.0), (-1.0, 3.0)])
def test_a_batch_begins_when_it_is_asked_to(t):
    model = Model("driven", {"w": 1.0}, ("x",), lambda s, p, t: (cos(p.w * t),))
    w = np.linspace(0.5, 1.5, 9)
    motions = integrate(model.changed(w=w), t, (np.ones(9),), method="taylor")
    exact = 1 + (np.sin(w * t[1]) - np.sin(w * t[0])) / w
    apart = abs(motions.states["x"].T - [np.ones(9), exact])
    assert motions.times.tolist() == list(t)
    assert (apart <= [np.zeros(9), np.maximum(1.0, abs(exact)) * motions.error]).all()
    assert (motions.error <= 1e-9).all()


@needs_heyoka
def test_a_batch_does_not_pass_over_a_pulse():
    pulse = lambda s, p, t: (p.h * exp(-(((t - 50) / 0.05) ** 2)),)
    h = np.linspace(1.0, 2.0, 5)
    model = Model("struck", {"h": h}, ("x",), pulse)
    motions = integrate(model, 100.0, (np.zeros(5),), method="taylor")
    assert motions.states["x"][:, -1] == pytest.approx(h * 0.05 * math.sqrt(math.pi), rel=1e-9)


@needs_heyoka
@pytest.mark.parametrize("samples", [[3.0, 2.0], [2.0, 2.0]], ids=str)
def test_samples_of_a_batch_increase_from_its_start(samples):
    with pytest.raises(ModelError, match="must increase from t = 0"):
        integrate(PENDULUM, 5.0, (amplitudes(3), np.zeros(3)), method="taylor", samples=samples)


@pytest.mark.parametrize("count", [1, 2, 70])
def test_the_errors_of_a_batch_of_closed_forms_are_those_asked_for(count):
    w = np.linspace(1.0, 3.0, count)
    motions = integrate(SPRING.changed(k=w * w), (1.0, 5.0), (np.ones(count), 0.0), samples=5)
    assert motions.method.name == "exact"
    assert motions.times.tolist() == [1.0, 2.0, 3.0, 4.0, 5.0]
    assert abs(motions.states["x"] - np.cos(w[:, None] * (motions.times - 1.0))).max() < 1e-13
    assert (motions.error == motions.rtol).all()  # nothing closer is known
    assert motions.cost.calls == 5  # no motion was computed by itself


def test_closed_forms_are_judged_at_their_starts_and_ends_with_something_to_spare(monkeypatch):
    judged = []

    def known_accurate(system, method, rtol, t0, t1, start, x):
        judged.append((math.sqrt(system.model.parameters["k"]), t1 - t0, start, x, rtol))
        return True

    monkeypatch.setattr(batch, "known_accurate", known_accurate)
    w = np.array([1.0, 1.0, 2.0, 2.0, 1.0, 2.0, 1.0, 2.0, 1.0])
    motions = integrate(SPRING.changed(k=w * w), (1.0, 5.0), (1.0, 0.0), 1e-9)
    ends = [(x, pytest.approx((math.cos(4 * x), -x * math.sin(4 * x)))) for x in (1.0, 2.0)]
    assert sorted(judged) == [(x, 4.0, (1.0, 0.0), end, 1e-9 / SPARE) for x, end in ends]
    assert (motions.error == 1e-9).all()


def test_motions_whose_closed_form_is_not_accurate_are_made_one_by_one(monkeypatch):
    """Here these are the motions of the faster spring, which have the second number."""
    monkeypatch.setattr(batch, "known_accurate", lambda s, *_: s.model.parameters["k"] == 1.0)
    w = np.array([1.0, 2.0, 1.0, 2.0, 1.0, 2.0, 1.0, 2.0])
    motions = integrate(SPRING.changed(k=w * w), 5.0, (1.0, 0.0), 1e-9, samples=3)
    assert (motions.error[::2] == 1e-9).all()
    assert (motions.error[1::2] < 1e-12).all()
    assert motions.cost.calls > 3
    assert motions.method.name == "exact"


def test_a_closed_form_that_is_not_accurate_is_refused_with_all_motions():
    words = r"2 of 2 .* the first is number 0: the closed form"
    with pytest.raises(AccuracyError, match=words) as refused:
        integrate(SPRING, 1e9, (np.array([1.0, 2.0]), 0.0), 1e-9, "exact")
    reached = refused.value.reached
    assert (reached.error > 1e-9).all()
    assert np.isfinite(reached.states["x"]).all()


def fresh():
    """A model of which no other test has made an integrator."""
    return second_order("fresh", {}, ("a",), lambda s, p, t: (-sin(s.a) - s.da / 64,))


@pytest.mark.parametrize(
    ("model", "count", "method", "found"),
    [
        (SPRING, 2, "dop853", "dop853"),  # although it has a closed form
        (fresh(), 3, "auto", "dop853"),  # as for one motion
        pytest.param(PENDULUM, MIN_HEYOKA_BATCH, "auto", "taylor", marks=needs_heyoka),
    ],
)
def test_many_motions_are_made_by_the_method_asked_for_or_worth_it(model, count, method, found):
    motions = integrate(model, 1.0, (amplitudes(count), 0.0), method=method)
    assert motions.method.name == found
    assert motions.cost.calls > 100


@pytest.mark.parametrize(("starts", "words", "stopped"), [
    ([1.0, 3.0], "1 of 2 motions are not as accurate as requested, the first is number 0", [0]),
    ([3.0, 1.0, 4.0, 1.0], "2 of 4 .* the first is number 1: fall could not be followed", [1, 3]),
])  # fmt: skip
def test_motions_that_stop_on_the_way_are_reported_with_those_that_do_not(starts, words, stopped):
    """With x' = -1/x, x reaches zero at t = x0^2/2."""
    x = np.array(starts)
    with pytest.raises(AccuracyError, match=words) as refused:
        integrate(FALL, 1.0, (x,), method="dop853", samples=[0.0, 0.25, 1.0])
    reached = refused.value.reached
    through = np.delete(np.arange(len(x)), stopped)
    assert np.isnan(reached.states["x"][stopped]).all()
    assert not (reached.error[stopped] <= 1e-9).any()
    assert reached.states["x"][through, 2] == pytest.approx(np.sqrt(x[through] ** 2 - 2))
    assert (reached.error[through] <= 1e-9).all()


DRIVEN = second_order("driven", {"w": 2.0}, ("x",), lambda s, p, t: (sin(p.w * t) - s.x,))


@needs_heyoka
@pytest.mark.parametrize(("t0", "least", "most"), [(0.0, 0.0, 5e-7), (1e9, 1e-6, 1e-4)])
def test_the_errors_of_a_batch_contain_what_the_clock_makes_of_a_force_in_time(t0, least, most):
    """At t = 1e9 the time is known to 1e-7 s."""
    w = np.array([1.0, 2.0, 3.0])
    motions = integrate(DRIVEN.changed(w=w), (t0, t0 + 0.5), START, 1e-4, "taylor")
    assert (least <= motions.error).all()
    assert (motions.error <= most).all()


def test_the_errors_by_the_clock_are_those_of_each_motion_or_a_bound_of_them():
    w, t0, t1 = np.array([1.0, 2.0, 3.0]), 900.0, 904.0
    model, ends, sizes = DRIVEN.changed(w=w), np.ones((2, 3)), np.full((2, 3), 0.5)
    system = PreparedModel(model)
    each = [
        time_round_off(PreparedModel(DRIVEN.changed(w=x)), t1, (1.0, 1.0), (0.5, 0.5), t1 - t0)
        for x in w.tolist()
    ]
    found = _clock_errors(system, t0, t1, ends, w[None], sizes, 0.0)
    assert found == pytest.approx(each, rel=1e-9, abs=0.0)
    bounds = _clock_errors(system, t0, t1, ends, w[None], sizes, 1.0)
    # the rate of these springs is 1/s, the time is 4 s
    assert bounds == pytest.approx(4 * found, rel=0.01, abs=0.0)
    # a motion without an end has no bound
    ends[:, 1] = math.nan
    assert _clock_errors(system, t0, t1, ends, w[None], sizes, 1.0)[[0, 2]].tolist() == [
        bounds[0],
        bounds[2],
    ]
    assert _clock_errors(PreparedModel(PENDULUM), t0, t1, ends, w[None], sizes, 0.0).max() == 0.0


@needs_heyoka
@pytest.mark.parametrize("names", ["", "p", "pq"])
def test_a_batch_takes_any_number_of_parameters(names):
    """x' = -(p + q) x, with whichever parameters there are."""
    rates = lambda s, p, t: (-(1.0 + sum(getattr(p, n) for n in names)) * s.x,)
    values = {n: np.array([0.25, 0.5, 0.75]) for n in names}
    model = Model("fading", dict.fromkeys(names, 1.0), ("x",), rates)
    x = np.array([1.0, 2.0, 3.0])
    found = integrate(model.changed(**values) if names else model, 2.0, (x,), method="taylor")
    exact = x * np.exp(-2.0 * (1.0 + len(names) * np.array([0.25, 0.5, 0.75])))
    assert found.states["x"][:, -1] == pytest.approx(exact, rel=1e-9)


# x'' = x from (1, -1): an error at the start grows as exp(t), so the error is known
SADDLE = second_order("saddle", {}, ("x",), lambda s, p, t: (s.x,))
GROWN = ROUND_OFF_OF_RATES * math.exp(15.0)


@needs_heyoka
@pytest.mark.parametrize(("rtol", "safety"), [(1e-6, 3.0), (2e-8, 1.2)])
def test_the_errors_of_a_batch_contain_the_round_off_of_its_start(rtol, safety):
    motions = integrate(SADDLE, 15.0, (np.ones(1), -np.ones(1)), rtol, "taylor")
    assert motions.error == pytest.approx(safety * GROWN, rel=0.1)


@needs_heyoka
def test_motions_alike_are_vouched_for_by_one_that_has_something_to_spare():
    """At the smaller rtol all the motions are compared, not just one batch of them."""
    x = np.linspace(1.0, 1.001, 64)
    least = SPARE * 1.03 * GROWN
    spare, none = (integrate(SADDLE, 15.0, (x, -x), f * least, "taylor") for f in (1.1, 0.9))
    assert none.cost.calls == pytest.approx(2 * spare.cost.calls, rel=0.15)
    assert spare.error[0] == pytest.approx(spare.rtol, rel=0.01)
    assert (none.error <= none.rtol).all()


@needs_heyoka
def test_a_motion_vouches_only_for_those_close_to_it():
    lanes = pytest.importorskip("heyoka").recommended_simd_size()  # motions in one batch

    def calls(count, width):
        a = np.linspace(1.0, 1.0 + width, 64)[:count]
        return integrate(PENDULUM, 3.0, (a, np.zeros(count)), 1e-9, "taylor").cost.calls

    one_batch = calls(lanes, 0.01) / 2  # at each of two tolerances
    assert calls(64, 0.01) == pytest.approx(one_batch * (64 / lanes + 1), rel=0.2)
    assert calls(64, 4.0) > 1.4 * calls(64, 0.01)


@needs_heyoka
def test_a_motion_vouches_for_a_smaller_state_by_the_size_of_that():
    """Motions that pass a spot of light: the farthest gets a hundredth of the nearest one's dose.
    Judged by the larger dose, the smaller ones were once wrong by 3.5 times the tolerance.
    """

    def rates(s, p, t):
        far = ((s.x - 1.0) ** 2 + (s.y - 0.5) ** 2) / (p.w * p.w)
        return s.u, s.v, -0.1 * s.u, -0.1 * s.v, 1 / p.w / (1 + far * far)

    model = Model("spot", {"w": 1e-3}, ("x", "y", "u", "v", "dose"), rates)
    v = 0.5 + np.linspace(-0.009, 0.009, 64)
    motions = integrate(model, 2.0, (0.0, 0.0, np.ones(64), v, 0.0), 1e-6, "taylor")
    for n in (0, 7, 16, 31, 52, 60, 63):
        true = integrate(model, 2.0, (0.0, 0.0, 1.0, v[n], 0.0), 1e-10, "dop853").end["dose"]
        assert abs(motions.states["dose"][n, -1] / true - 1) <= motions.error[n] <= 1e-6


@needs_heyoka
def test_a_state_that_is_zero_at_the_ends_of_a_motion_is_as_large_as_on_the_way():
    v = np.array([1.0, 2.0, 3.0])
    spring = second_order("spring", {}, ("x",), lambda s, p, t: (-s.x,))
    motions = integrate(spring, math.pi, (0 * v, v), 1e-9, "taylor")
    assert (motions.error < 1e-11).all()
    assert motions.cost.calls < 2 * integrate(spring, 3.0, (0 * v, v), 1e-9, "taylor").cost.calls
    still = integrate(spring.changed(), 3.0, (0 * v, 0 * v), 1e-9, "taylor")
    assert (still.error < 1e-12).all()  # a state that is always zero is not refused either


@needs_heyoka
@pytest.mark.parametrize("count", [1, 3, 8, 9])  # heyoka takes 2, 4 or 8 at once
@pytest.mark.parametrize("times", [[0.0, 1.0], [1.0], [0.5, 1.0], [0.0, 0.5, 1.0]], ids=str)
def test_where_some_motions_stop_on_the_way_the_others_go_on(times, count):
    """With x' = -1/x, x reaches zero at t = x0^2/2: for every third of these at 0.5 s."""
    system = PreparedModel(FALL)
    starts = np.where(np.arange(count) % 3 == 1, 0.7, 3.0)[None]
    p, times = np.zeros((0, count)), np.array(times)
    found, calls = batches(system, 1e-12, starts, p, 0.0, times)
    assert calls > 20
    for n, x in enumerate(starts[0]):
        if x == 3.0:
            assert found[0, n] == pytest.approx(np.sqrt(9.0 - 2 * times))
        else:
            assert np.isnan(found[0, n, -1])
            if times[0] == 0.0:
                assert found[0, n, 0] == x


@pytest.mark.parametrize(
    ("starts", "n", "events", "words"),
    [
        ((np.ones(3), 0.0), 1.0, Event(lambda s, p, t: s.a), "events need one motion at a time"),
        ((np.ones(3), np.zeros(2)), 1.0, (), r"do not fit together: a \(3,\), da \(2,\)"),
        ((np.ones((2, 2)), 0.0), 1.0, (), "one dimension, got"),
        ((np.array([1.0, math.nan]), 0.0), 1.0, (), "must be finite numbers"),
        ((1.0, 0.0), np.array([1.0, math.inf]), (), "must be finite numbers"),
        ((1.0, 0.0), np.array([1.0, 2j]), (), "the parameter n of .* give its real part"),
        ((np.zeros(0), 0.0), 1.0, (), "no entries: there is no motion"),
    ],
)
def test_what_no_batch_can_begin_with_is_refused(starts, n, events, words):
    with pytest.raises(ModelError, match=words):
        integrate(PENDULUM.changed(n=n), 1.0, starts, events=events)


@pytest.mark.parametrize(
    "options", [{"method": "verlet", "step": 0.125}, {"method": "dop853"}], ids=str
)
def test_without_heyoka_each_motion_of_a_batch_is_integrated_by_itself(options):
    a = amplitudes(3)
    motions = integrate(PENDULUM, (1.0, 4.0), (a, np.zeros(3)), samples=4, **options)
    each = [integrate(PENDULUM, (1.0, 4.0), (x, 0.0), samples=4, **options) for x in a]
    assert motions.method.name == options["method"]
    assert motions.states["a"].tolist() == [one.states["a"].tolist() for one in each]
    assert np.array_equal(motions.error, [one.error for one in each], equal_nan=True)
    assert motions.cost.calls == sum(one.cost.calls for one in each)


def test_a_batch_needs_a_method_by_name_for_a_fixed_step_and_changes_no_prepared_model():
    with pytest.raises(ModelError, match="a fixed step needs a method by name"):
        integrate(SPRING, 1.0, (amplitudes(3), np.zeros(3)), step=0.125)
    before = prepared_model(PENDULUM).p
    integrate(PENDULUM.changed(n=np.array([1.0, 2.0])), 1.0, (1.0, 0.0), method="dop853")
    assert prepared_model(PENDULUM).p == before
