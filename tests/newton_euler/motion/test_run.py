"""Which method one integration takes, how its error is predicted, and what is said if that is too
large.
"""

import importlib.util
import itertools
import math
from types import SimpleNamespace

import pytest

from newton_euler import Model, cos, exp, integrate, sin, sqrt
from newton_euler.motion import ModelError, second_order
from newton_euler.motion import run as control_run
from newton_euler.motion.events import Event, EventError
from newton_euler.motion.methods.base import MAX_STEPS
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.methods.taylor import level_of
from newton_euler.motion.prepared import PreparedModel, prepared_model
from newton_euler.motion.run import (
    FEW_STEPS,
    HEYOKA_BREAK_EVEN,
    IRREGULAR,
    MIN_STEPS,
    REGULAR,
    RESIDUAL_SAFETY,
    ROUND_OFF,
    ROUND_OFF_OF_RATES,
    SAFETY,
    SERIES_ROUND_OFF,
    SERIES_SAFETY,
    SIZE_SAMPLES,
    STEPS_OFF,
    AccuracyError,
    Run,
    check,
    checked_samples,
    predicted,
    predicted_error,
    span,
    told,
    usable,
    verified_series,
)
from newton_euler.motion.solution import MotionError
from newton_euler.motion.trajectory import Segment

HEYOKA = importlib.util.find_spec("heyoka") is not None
needs_heyoka = pytest.mark.skipif(not HEYOKA, reason="heyoka is not installed")
PENDULUM = second_order("pendulum", {}, ("a",), lambda s, p, t: (-sin(s.a),))
START = (1.0, 0.0)


def run(model=PENDULUM, t1=10.0, state=START, rtol=1e-9, t0=0.0, **options):
    return Run(prepared_model(model), t0, t1, state, rtol, **options)


# -- what is asked


@pytest.mark.parametrize(
    ("t", "found"),
    [(2.0, (0.0, 2.0)), (3, (0.0, 3.0)), ((1, 2.5), (1.0, 2.5)), ([-2.0, -1.0], (-2.0, -1.0))],
)
def test_the_time_is_an_end_or_a_pair(t, found):
    assert span(t) == found
    assert all(type(x) is float for x in span(t))


@pytest.mark.parametrize(
    "t", ["x", "12", b"12", True, None, (1.0,), (1.0, 2.0, 3.0), (1.0, None)], ids=str
)
def test_a_time_that_is_none_is_said(t):
    with pytest.raises(ModelError, match=r"time at which to end, or \(from, to\)"):
        span(t)


@pytest.mark.parametrize(
    "t",
    [
        *(0.0, -1.0, 0, math.inf, math.nan),
        *((1.0, 1.0), (2.0, 1.0), (0.0, math.inf), (-math.inf, 1.0), (math.nan, 1)),
    ],
)
def test_time_runs_forward_and_is_finite(t):
    with pytest.raises(ModelError, match="time runs forward"):
        span(t)


@pytest.mark.parametrize(
    ("method", "rtol"),
    [("auto", 1e-15), ("taylor", 1e-15), ("dop853", 1e-13), ("verlet", 1e-7), ("auto", 0.999)],
)
def test_an_rtol_that_a_method_reaches_is_taken_and_less_refused(method, rtol):
    check(rtol, method)
    if rtol < 0.5:
        with pytest.raises(ModelError, match=f"cannot reach it, the least is {rtol:g}"):
            check(0.99 * rtol, method)


@pytest.mark.parametrize("rtol", [0.0, -1e-9, 1.0, 2, math.nan, "1e-9", None, True])
def test_an_rtol_lies_between_0_and_1(rtol):
    with pytest.raises(ModelError, match="it lies below 1"):
        check(rtol, "auto")
    check(rtol, "verlet", step=0.1)  # with a fixed step it does not matter


@pytest.mark.parametrize("step", [0.0, -0.1, math.nan, math.inf, True, "0.1"])
def test_a_step_is_positive(step):
    with pytest.raises(ModelError, match="the step is a positive time"):
        check(1e-6, "verlet", step=step)


def test_a_method_and_events_are_what_they_must_be():
    with pytest.raises(ModelError, match="no method 'euler'; take 'auto' or one of exact, taylor"):
        check(1e-6, "euler")
    with pytest.raises(ModelError, match=r"events are made by Event"):
        check(1e-6, "auto", [lambda s, p, t: s.a])
    with pytest.raises(ModelError, match=r"no method \['verlet'\]"):
        check(1e-6, ["verlet"])
    check(1e-6, "auto", [Event(lambda s, p, t: s.a)])


def test_progress_is_told_to_a_function():
    check(1e-6, "auto", progress=print)
    with pytest.raises(ModelError, match="progress is a function of the fraction"):
        check(1e-6, "auto", progress=0.5)


@pytest.mark.parametrize("samples", [None, 1, 7])
def test_a_number_of_samples_stays_as_it_is(samples):
    assert checked_samples(samples, 2.0, 5.0) is samples


@pytest.mark.parametrize("samples", [[2.0, 3.5, 5.0], (2, 5), (t for t in (2.0, 5.0)), [5.0]])
def test_samples_are_times_of_the_motion_its_ends_among_them(samples):
    found = checked_samples(samples, 2.0, 5.0)
    assert found.dtype == float
    assert {found[0], found[-1]} <= {2.0, 5.0}


@pytest.mark.parametrize("samples", [0, -1, 2.5, True, "4", b"4", [], [[3.0, 4.0]], ["x"]], ids=str)
def test_samples_that_are_none_are_said(samples):
    with pytest.raises(ModelError, match="samples are a number of times, or times, got"):
        checked_samples(samples, 2.0, 5.0)


@pytest.mark.parametrize("t", [1.99, 5.01, math.nan])
def test_samples_outside_the_motion_are_refused(t):
    with pytest.raises(ModelError, match=f"from t = 2 to 5, where .* got {t:g} among them"):
        checked_samples([3.0, t, 4.0], 2.0, 5.0)


def test_a_method_that_cannot_be_used_says_why():
    assert usable("dop853", prepared_model(PENDULUM)) is METHODS["dop853"]
    with pytest.raises(ModelError, match="'exact' cannot be used: no exact solution of 'pendulum'"):
        usable("exact", prepared_model(PENDULUM))
    driven = Model("driven", {}, ("x",), lambda s, p, t: (t,), exact=lambda s, p, t: (s.x + t * t,))
    assert usable("exact", prepared_model(driven)) is METHODS["exact"]
    with pytest.raises(ModelError, match="its exact solution starts at t = 0"):
        usable("exact", prepared_model(driven), 1.0)


def test_a_fixed_step_needs_a_method_that_has_one_and_tells_no_error():
    motion = run(step=0.125).by_name("yoshida4")
    assert math.isnan(motion.error)
    assert motion.segments[0].stepper.step_times[1] == 0.125
    with pytest.raises(ModelError, match="needs a method by name"):
        run(step=0.1).by_name("auto")
    with pytest.raises(ModelError, match="'scipy LSODA' has no fixed step"):
        run(step=0.1).by_name("scipy LSODA")


# -- the prediction


def test_the_error_of_a_fine_run_is_a_power_of_the_ratio_of_the_tolerances():
    d, ratio, tolerance = 1e-5, 1e-3, 1e-12
    for regular, power in ((True, REGULAR), (False, IRREGULAR)):
        found = predicted(d, ratio, tolerance, regular)
        assert found == pytest.approx(SAFETY * d * ratio**power, rel=1e-6)
    assert predicted(d, ratio, tolerance) == predicted(d, ratio, tolerance, True, 0)


def test_no_error_is_below_the_tolerance_nor_below_round_off():
    assert predicted(0.0, 1e-3, 1e-7) == pytest.approx(1e-7, rel=1e-6)
    assert predicted(0.0, 1e-3, 0.0) == ROUND_OFF
    assert predicted(0.0, 54.0, 1e-7) == SERIES_ROUND_OFF


def test_beside_a_more_accurate_run_the_difference_is_the_error():
    assert predicted(1e-8, 54.0, 1e-3) == pytest.approx(SERIES_SAFETY * 1e-8, rel=1e-5)
    assert predicted(1e-8, 1.5, 1e-3) == predicted(1e-8, 54.0, 1e-3)
    # of equal tolerances neither is
    assert predicted(1e-8, 1.0, 1e-12) == pytest.approx(SAFETY * 1e-8, rel=1e-5)


def test_round_off_grows_as_the_root_of_the_number_of_steps():
    for ratio, one in ((1e-3, ROUND_OFF), (54.0, SERIES_ROUND_OFF)):
        assert predicted(0.0, ratio, 0.0, True, 0) == one
        assert predicted(0.0, ratio, 0.0, True, 300) == pytest.approx(2 * one, rel=1e-9, abs=0.0)
        assert predicted(0.0, ratio, 0.0, True, 10**6) == pytest.approx(
            100 * one, rel=1e-3, abs=0.0
        )


def test_two_runs_that_are_far_apart_predict_nothing():
    assert predicted(0.051, 1e-3, 1e-9) == 0.051
    assert predicted(0.049, 1e-3, 1e-9) < 0.01
    assert predicted(0.05, 54.0, 1e-9) > 0.1
    assert math.isnan(predicted(math.nan, 1e-3, 1e-9))
    assert predicted(math.inf, 1e-3, 1e-9) == math.inf


@pytest.mark.parametrize("what", ["kinks", "hazards"])
def test_where_formulas_change_the_prediction_is_the_careful_one(monkeypatch, what):
    method, one = METHODS["dop853"], run(t1=50.0)
    before, fine = one.trajectory(method, 1e-7), one.trajectory(method, 1e-10)
    found = [predicted_error(before, fine, method)]
    monkeypatch.setitem(vars(one.system.traced), what, ["abs"])
    found.append(predicted_error(before, fine, method))
    assert found[1] / found[0] == pytest.approx(1e-3 ** (IRREGULAR - REGULAR), rel=1e-3)


@pytest.mark.parametrize("method", ["dop853", "scipy RK45", "taylor"])
def test_the_error_contains_what_the_clock_makes_of_a_force_in_time(method):
    """x' = sin(w t) at t = 1e9: the time is known to 1e-7 s."""
    if not HEYOKA and method == "taylor":
        pytest.skip("heyoka is not installed")
    model = second_order("driven", {"w": 2.0}, ("x",), lambda s, p, t: (sin(p.w * t) - s.x,))
    errors = [integrate(model, (t0, t0 + 2.0), START, 1e-5, method).error for t0 in (0.0, 1e9)]
    assert errors[1] > 1e-7
    if method == "taylor":
        assert errors[0] < 3e-8


class Still:
    """A system whose rates do not depend on time, and have these places."""

    autonomous = True

    def __init__(self, kinks=(), hazards=()):
        self.traced = SimpleNamespace(kinks=kinks, hazards=hazards)


def made(steps, tolerance=1e-12, difference=0.0, system=None, residuals=(0.0,)):
    """A trajectory of so many steps in each segment."""
    parts = [
        Segment(
            system or Still(),
            SimpleNamespace(step_times=range(n + 1), scales=(1.0,), residual=lambda r=r: r),
            0.0,
            1.0,
            (1.0,),
        )
        for n, r in itertools.zip_longest(steps, residuals, fillvalue=0.0)
    ]
    return SimpleNamespace(segments=parts, tolerance=tolerance, difference=lambda other: difference)


def is_regular(method, coarse, fine, ratio=1e-3):
    """True if the prediction is that of runs in the regime of small errors."""
    before, after = made(coarse, 1e-12 / ratio, 1e-4), made(fine)
    found = predicted_error(before, after, METHODS[method])
    given = [predicted(1e-4, ratio, 1e-12, regular, sum(fine)) for regular in (False, True)]
    return given.index(pytest.approx(found, rel=1e-9))


@pytest.mark.parametrize(("steps", "regular"), [(MIN_STEPS - 1, False), (MIN_STEPS, True)])
@pytest.mark.parametrize("method", ["yoshida4", "scipy LSODA"])
def test_few_steps_are_not_in_the_regime_of_small_errors(method, steps, regular):
    assert is_regular(method, [steps], [100]) == regular
    assert is_regular(method, [steps - 3, 3], [100]) == regular


def test_the_steps_of_a_series_do_not_matter():
    """Its tolerance sets its order."""
    assert is_regular("taylor", [1], [1])


@pytest.mark.parametrize(
    ("coarse", "fine", "regular"),
    [
        ([1000], [2371], True),  # 1000^(1/8)
        ([1000], [2371 / STEPS_OFF - 9], False),
        ([1000], [2371 / STEPS_OFF + 9], True),
        ([1000], [2371 * STEPS_OFF - 9], True),
        ([1000], [2371 * STEPS_OFF + 9], False),
        ([500, 500], [1371, 1000], True),
        ([0], [1], False),
        ([MIN_STEPS - 1], [17], False),
        ([MIN_STEPS], [19], True),
    ],
)
def test_steps_that_do_not_grow_as_the_order_has_it_are_not_in_the_regime(coarse, fine, regular):
    fine = [int(n) for n in fine]
    assert is_regular("dop853", coarse, fine) == regular
    if sum(coarse) >= MIN_STEPS:  # of a fixed step they follow from the tolerance
        assert is_regular("yoshida8", coarse, fine)


def test_round_off_grows_with_the_steps_of_the_fine_run():
    found = predicted_error(made([1000], 1e-17), made([200, 100], 1e-20), METHODS["dop853"])
    assert found == pytest.approx(2 * ROUND_OFF, rel=1e-6, abs=0.0)


def test_the_round_off_of_the_clock_is_that_of_the_last_segment(monkeypatch):
    asked = []

    def recorded(system, t, x, sizes, span):
        asked.append((t, x, sizes, span))
        return 0.25

    monkeypatch.setattr(control_run, "time_round_off", recorded)
    fine = made([9, 9])
    stepper = SimpleNamespace(step_times=range(10), scales=(2.0,))
    fine.segments[1] = Segment(Still(), stepper, 3.0, 10.0, (5.0,))
    assert predicted_error(made([9, 9]), fine, METHODS["dop853"]) == pytest.approx(0.25)
    # a segment that has no length has a span too
    fine.segments[1] = Segment(Still(), stepper, 3.0, 3.0, (5.0,))
    predicted_error(made([9, 9]), fine, METHODS["dop853"])
    assert asked == [(10.0, (5.0,), (2.0,), 7.0), (3.0, (5.0,), (2.0,), 1.0)]


def test_where_a_series_may_not_see_all_of_the_rates_its_worst_residual_counts():
    def judged(method, hazards):
        fine = made([9, 9, 9], system=Still((), hazards), residuals=(1e-6, 3e-6, 2e-6))
        return predicted_error(made([9]), fine, METHODS[method])

    assert judged("taylor", ["sqrt"]) == pytest.approx(RESIDUAL_SAFETY * 3e-6)
    assert judged("taylor", []) == judged("dop853", ["sqrt"]) < 1e-11


# -- the run that it is compared with


def start_of(trajectory):
    return trajectory.segments[0].stepper.start[1]


def test_the_run_that_another_is_compared_with_starts_a_little_beside():
    """So that what is predicted contains round-off of the rates: times the factor of the
    prediction, the shift is that.
    """
    method, one = METHODS["dop853"], run(state=(1.0, 2.0))
    coarse = one.compared(method, 1e-4, 1e-7)
    shift = [a / b - 1 for a, b in zip(start_of(coarse), (1.0, 2.0), strict=True)]
    back = ROUND_OFF_OF_RATES / (SAFETY * 1e-3**REGULAR)
    assert shift == pytest.approx([back, -back], rel=1e-2, abs=3e-16)
    assert coarse.calls == one.calls > 0
    fine = one.compared(method, 1e-9, 1e-7)
    apart = [a / b - 1 for a, b in zip(start_of(fine), (1.0, 2.0), strict=True)]
    part = ROUND_OFF_OF_RATES / SERIES_SAFETY
    assert apart == pytest.approx([part, -part], abs=3e-16)
    assert one.state == (1.0, 2.0)


def test_every_second_state_is_shifted_the_other_way():
    model = Model("still", {}, tuple("abcde"), lambda s, p, t: (0.0 * s.a,) * 5)
    coarse = run(model, state=(1.0,) * 5).compared(METHODS["dop853"], 1e-4, 1e-7)
    assert [x > 1 for x in start_of(coarse)] == [True, False, True, False, True]


def test_with_events_it_starts_at_the_same_place():
    """It may lie on the surface of one."""
    one = run(state=(1.0, 2.0), events=(Event(lambda s, p, t: s.a - 1.0),))
    assert start_of(one.compared(METHODS["dop853"], 1e-4, 1e-7)) == (1.0, 2.0)


def test_all_runs_are_counted_in_the_cost():
    one = run()
    motion = one.by_name("dop853")
    assert motion.cost.calls == one.calls > motion.segments[0].stepper.calls
    assert motion.cost.preparing == 0.0
    assert run(preparing=0.5).by_name("dop853").cost.preparing == 0.5


# -- until it is accurate enough


class Scripted(Run):
    """A run whose trajectories are not integrated: their errors are given."""

    def trajectory(self, method, tolerance, *more):
        self.asked.append((tolerance, *more))
        return SimpleNamespace(tolerance=tolerance, failed=self.failing, sizes=lambda: "sizes")

    def compared(self, method, tolerance, fine, *more):
        self.beside.append((tolerance, fine, *more))
        return SimpleNamespace(tolerance=tolerance, failed=None, sizes=lambda: "sizes")

    def motion(self, trajectory, method, error):
        found = SimpleNamespace(error=error, t_end=1.0, method=method, trajectory=trajectory)
        if trajectory.failed:
            raise MotionError("failed", found)
        return found


@pytest.fixture
def scripted(monkeypatch):
    """A function of the errors that are found, in order: the run, and the pairs of tolerances,
    coarse and fine, that were compared.
    """

    def make(errors, rtol=1e-9, failing=None):
        pairs, errors = [], iter(errors)

        def judged(before, trajectory, method):
            pairs.append((before.tolerance, trajectory.tolerance))
            return next(errors)

        monkeypatch.setattr(control_run, "predicted_error", judged)
        one = Scripted(prepared_model(PENDULUM), 0.0, 1.0, START, rtol)
        one.asked, one.beside, one.failing = [], [], failing
        return one, pairs

    return make


def close_to(*pairs):
    return [pytest.approx(pair, rel=1e-9, abs=0.0) for pair in pairs]


def test_an_error_that_is_small_enough_needs_no_other_run(scripted):
    one, pairs = scripted([1e-9])
    motion = one.calibrated(METHODS["dop853"])
    assert motion.error == 1e-9
    assert pairs == close_to((1e-8, 1e-11))
    assert one.asked == [(pytest.approx(1e-11), "sizes", False)]
    assert one.beside == [(pytest.approx(1e-8), pytest.approx(1e-11), None, False, None)]


@pytest.mark.parametrize(("error", "factor"), [(1e-5, 0.05), (1.1e-6, 0.1), (1e-2, 1e-3)])
def test_the_next_tolerance_goes_by_the_error_of_the_last(scripted, error, factor):
    """Half of what was asked for, but not less than a tenth, nor more than a thousandth; the run
    before is what it is compared with.
    """
    one, pairs = scripted([error, 1e-7], rtol=1e-6)
    assert one.calibrated(METHODS["dop853"]).error == pytest.approx(told(1e-7, 1e-6))
    assert pairs == close_to((1e-5, 1e-8), (1e-8, 1e-8 * factor))
    assert [known for _, *known in one.asked] == [["sizes", False]] * 2


def test_a_fixed_step_is_compared_with_a_run_beside_the_start_each_time(scripted):
    one, pairs = scripted([1e-5, 1e-7], rtol=1e-6)
    one.calibrated(METHODS["yoshida4"])
    first = 1e-6 / 30.0
    assert pairs == close_to((1e3 * first, first), (50 * first, 0.05 * first))
    assert [known for _, _, *known in one.beside] == [[None, False, None], ["sizes", False]]


@pytest.mark.parametrize("closer", [8e-13, 3e-11])
def test_at_the_finest_tolerance_a_run_closer_to_it_may_tell_more(scripted, closer):
    one, pairs = scripted([5e-12, closer], rtol=1e-12)
    if closer < 1e-12:
        error = one.calibrated(METHODS["dop853"]).error
    else:
        with pytest.raises(AccuracyError) as refused:
            one.calibrated(METHODS["dop853"])
        error = refused.value.reached.error
    assert error == min(told(closer, 1e-12), 5e-12)
    assert pairs == close_to((1e-11, 1e-14), (1e-13, 1e-14))
    assert one.beside[1][2:] == ("sizes", False)


@pytest.mark.parametrize(("rtol", "second"), [(1.5e-12, (1.5e-13, 1.5e-14)), (2.5e-12, None)])
def test_a_tolerance_that_is_hardly_smaller_is_not_tried(scripted, rtol, second):
    one, pairs = scripted([5e-12, 1e-12], rtol)
    one.calibrated(METHODS["dop853"])
    assert pairs[1:] == close_to(second or (2.5e-14, 1e-14))


def test_after_five_runs_it_is_refused_with_the_last_error(scripted):
    one, pairs = scripted([9e-3, 8e-3, 7e-3, 6e-3, 5e-3], rtol=1e-3)
    with pytest.raises(AccuracyError, match=r"asked for; ask for rtol = 0\.01") as refused:
        one.calibrated(METHODS["dop853"])
    assert refused.value.reached.error == 5e-3
    assert refused.value.reached.trajectory.tolerance == one.asked[-1][0]
    assert len(pairs) == len(one.asked) == 5
    # also the first tolerances have a limit
    assert pairs[0] == pytest.approx((1e-4, 3e-6))


def test_a_run_that_fails_is_not_made_again(scripted):
    one, pairs = scripted([1.0], failing=ArithmeticError())
    with pytest.raises(MotionError, match="failed"):
        one.calibrated(METHODS["dop853"])
    assert len(pairs) == 1


def test_an_error_that_is_no_number_is_refused(scripted):
    one, _ = scripted([math.nan] * 5)
    with pytest.raises(AccuracyError, match="no digit is certain"):
        one.calibrated(METHODS["dop853"])


def test_runs_of_heyoka_are_scaled_where_they_are_made_with_all_care(scripted):
    one, pairs = scripted([1e-10])
    one.calibrated(METHODS["taylor"])
    first = 1e-9 / 10**1.5
    assert pairs == close_to((first / 54, first))
    assert one.asked == [(pytest.approx(first), "sizes", True)]
    assert one.beside[0][2:] == (None, True, SIZE_SAMPLES)


def test_a_motion_that_would_take_too_many_steps_is_not_begun_a_second_time():
    one = run(t1=1e6, max_steps=1e4)
    with pytest.raises(MotionError, match="steps would be needed to t = 1e") as told:
        one.by_name("dop853")
    assert told.value.reached.cost.calls == told.value.reached.segments[0].stepper.calls
    assert math.isnan(told.value.reached.error)


def test_after_a_first_run_that_fails_the_second_knows_no_sizes(scripted, monkeypatch):
    one, _ = scripted([1e-10])
    first = SimpleNamespace(tolerance=1e-8, failed=ArithmeticError())
    monkeypatch.setattr(one, "compared", lambda *_: first)
    one.calibrated(METHODS["dop853"])
    assert one.asked == [(pytest.approx(1e-11), None, False)]


@pytest.fixture
def clock(monkeypatch):
    """A function that sets the clock: it goes on by so many seconds each time it is read."""

    def set_to(step):
        times = itertools.count(1e5, step)
        monkeypatch.setattr(control_run, "perf_counter", lambda: next(times))

    return set_to


@pytest.mark.parametrize(("seconds", "taken"), [(0.2, False), (0.22, True)])
def test_heyoka_takes_over_where_the_first_run_shows_that_the_second_would_be_slow(
    scripted, clock, monkeypatch, seconds, taken
):
    """A thousandth of the tolerance is 1000^(1/8) = 2.37 times the time, and half a second is
    earned back.
    """
    clock(seconds)
    one, pairs = scripted([1e-10, 1e-10])
    monkeypatch.setattr(one, "by", lambda method: method.name)
    assert (one.calibrated(METHODS["dop853"], True) == "taylor") == taken
    assert len(pairs) == (not taken)
    assert one.calibrated(METHODS["dop853"]) != "taylor"


def test_where_heyoka_fails_the_second_run_is_made(scripted, clock, monkeypatch):
    def fails(method):
        raise MotionError("no series", None)

    clock(9.0)
    one, pairs = scripted([1e-10])
    monkeypatch.setattr(one, "by", fails)
    assert one.calibrated(METHODS["dop853"], True).error == pytest.approx(3e-10)
    assert len(pairs) == 1


def test_the_seconds_of_all_runs_are_kept_for_the_next(scripted, clock):
    clock(0.125)
    one, _ = scripted([1e-10])
    before = one.system.traced.seconds
    one.calibrated(METHODS["dop853"])
    assert one.system.traced.seconds == before + 0.125


def test_the_seconds_of_the_cost_begin_with_the_run(clock):
    clock(0.5)
    one = run(started=99_000.0)
    assert one.motion(one.trajectory(METHODS["dop853"], 1e-6), METHODS["dop853"], 0.0).cost == (
        1000.0,
        0.0,
        one.calls,
    )


# -- auto


class Auto(Run):
    """A run by methods whose outcome is given by name: a motion, or what they raise."""

    def candidates(self):
        return [(METHODS[name], watched) for name, watched in self.order]

    def by(self, method):
        return self.outcome(method.name)

    def calibrated(self, method, heyoka=False):
        return self.outcome(method.name + " watched" * heyoka)

    def outcome(self, name):
        self.tried.append(name)
        found = self.outcomes[name]
        if isinstance(found, Exception):
            raise found
        return found


def auto(outcomes, order, exact=None):
    model = second_order("free", {}, ("a",), lambda s, p, t: (0.0 * s.a,), exact=exact)
    one = Auto(prepared_model(model), 0.0, 1.0, START, 1e-9)
    one.outcomes, one.order, one.tried = outcomes, order, []
    return one


def inaccurate(error):
    return AccuracyError(f"error {error}", SimpleNamespace(error=error))


def stopped(error):
    return MotionError(f"stopped with {error}", SimpleNamespace(error=error))


def free(s, p, t):
    return s.a + s.da * t, s.da


FIRST = [("dop853", True), ("taylor", False)]
SECOND = [("taylor", False), ("dop853", False)]


def test_auto_takes_the_closed_form_if_there_is_one():
    one = auto({"exact": "closed"}, FIRST, free)
    assert one.by_name("auto") == "closed"
    assert auto({"dop853 watched": "numbers"}, FIRST).by_name("auto") == "numbers"


def test_after_a_closed_form_that_is_not_accurate_few_steps_are_tried():
    one = auto({"exact": inaccurate(1e-3), "dop853 watched": "numbers"}, FIRST, free)
    assert one.by_name("auto") == "numbers"
    assert one.max_steps == FEW_STEPS
    # what they can still do: some thousand turns
    assert 1e4 < FEW_STEPS < 1e6


def test_a_closed_form_without_a_value_leaves_it_to_other_methods():
    one = auto({"exact": ModelError("no value"), "dop853 watched": "numbers"}, FIRST, free)
    assert one.by_name("auto") == "numbers"
    assert one.max_steps == MAX_STEPS


def test_an_event_that_cannot_be_used_is_not_tried_with_other_methods():
    one = auto({"exact": EventError("no number")}, FIRST, free)
    with pytest.raises(EventError):
        one.by_name("auto")
    assert one.tried == ["exact"]


@pytest.mark.parametrize("order", [FIRST, SECOND])
def test_where_one_method_is_not_accurate_the_other_is_tried(order):
    names = [name + " watched" * watched for name, watched in order]
    one = auto({names[0]: inaccurate(1e-3), names[1]: "found"}, order)
    assert one.by_name("auto") == "found"
    assert one.tried == names


def test_a_series_that_stops_leaves_it_to_runge_kutta_but_not_the_other_way():
    one = auto({"taylor": stopped(0.1), "dop853": "found"}, SECOND)
    assert one.by_name("auto") == "found"
    one = auto({"dop853 watched": stopped(0.1), "taylor": "found"}, FIRST)
    with pytest.raises(MotionError, match=r"stopped with 0\.1"):
        one.by_name("auto")
    assert one.tried == ["dop853 watched"]


def test_after_one_method_was_not_accurate_runge_kutta_may_stop():
    one = auto(
        {"exact": inaccurate(1e-3), "dop853 watched": stopped(0.1), "taylor": "found"}, FIRST, free
    )
    assert one.by_name("auto") == "found"


@pytest.mark.parametrize(
    ("taylor", "dop853", "words"),
    [
        (inaccurate(1e-3), inaccurate(1e-5), "error 1e-05"),
        (inaccurate(1e-5), inaccurate(1e-3), "error 1e-05"),
        (inaccurate(1e-3), stopped(1e-5), r"error 0\.001"),
        (stopped(1e-5), inaccurate(1e-3), r"error 0\.001"),
        (stopped(0.2), stopped(0.1), r"stopped with 0\.1"),
    ],
)
def test_of_several_refusals_the_most_accurate_is_told(taylor, dop853, words):
    one = auto({"taylor": taylor, "dop853": dop853}, SECOND)
    with pytest.raises(MotionError, match=words):
        one.by_name("auto")


@pytest.mark.parametrize(
    ("method", "hazards", "way"),
    [
        ("exact", (), "closed"),
        ("taylor", (), "series"),
        ("taylor", ("sqrt",), "calibrated"),
        ("dop853", (), "calibrated"),
    ],
)
def test_a_series_that_sees_all_of_the_rates_is_made_without_all_care(
    monkeypatch, method, hazards, way
):
    one = Run(SimpleNamespace(traced=SimpleNamespace(hazards=hazards)), 0.0, 1.0, START, 1e-9)
    for name in ("closed", "series", "calibrated"):
        monkeypatch.setattr(one, name, lambda method, name=name: (name, method.name))
    assert one.by(METHODS[method]) == (way, method)


def candidates(rtol=1e-9, hazards=(), kinks=(), integrators=(), seconds=0.0):
    traced = SimpleNamespace(
        hazards=hazards, kinks=kinks, integrators=dict.fromkeys(integrators), seconds=seconds
    )
    system = SimpleNamespace(traced=traced, model=SimpleNamespace(name="any"))
    one = Run(system, 0.0, 1.0, START, rtol)
    return [(method.name, heyoka) for method, heyoka in one.candidates()]


@needs_heyoka
def test_auto_begins_with_heyoka_once_its_compilation_is_earned_back():
    first = [("dop853", True), ("taylor", False)]
    second = [("taylor", False), ("dop853", False)]
    assert candidates() == first
    assert candidates(seconds=HEYOKA_BREAK_EVEN) == first
    assert candidates(seconds=1.01 * HEYOKA_BREAK_EVEN) == second
    assert candidates(integrators=["compiled"]) == second


@needs_heyoka
def test_auto_leaves_to_runge_kutta_what_a_series_does_not_see():
    alone = [("dop853", False)]
    assert candidates(hazards=["sqrt"], seconds=9.0) == alone
    assert candidates(kinks=["where"], seconds=9.0) == alone
    with pytest.raises(
        ModelError, match=r"rtol = 1e-14 needs heyoka, .* least is 1e-13; the rates"
    ):
        candidates(1e-14, kinks=["where"])


@needs_heyoka
def test_auto_takes_only_heyoka_for_what_is_too_tight_for_runge_kutta():
    least = METHODS["dop853"].min_rtol
    assert (
        candidates(0.5 * least) == candidates(0.5 * least, hazards=["sqrt"]) == [("taylor", False)]
    )
    assert candidates(least) == [("dop853", True), ("taylor", False)]


def test_auto_without_heyoka_is_runge_kutta(monkeypatch):
    from newton_euler.motion.methods import table

    monkeypatch.setattr(table, "installed", lambda: False)
    assert candidates(seconds=9.0) == [("dop853", False)]
    with pytest.raises(ModelError, match=r"needs heyoka, .* not installed"):
        candidates(1e-14)


def lorenz():
    """A model whose motions forget their starts in some tens of seconds."""
    rates = lambda s, p, t: (10 * (s.y - s.x), s.x * (28 - s.z) - s.y, s.x * s.y - 8 / 3 * s.z)
    return Model("Lorenz", {}, ("x", "y", "z"), rates)


def test_auto_returns_the_more_accurate_of_what_it_was_refused():
    """A motion that no float can follow: the error is that of .reached."""
    with pytest.raises(AccuracyError, match="the motion forgets its start") as told:
        integrate(lorenz(), 60.0, (1.0, 1.0, 20.0))
    assert told.value.reached.error > 0.05
    assert told.value.reached.t_end == 60.0


@needs_heyoka
def test_where_rates_have_no_value_auto_says_so_with_what_was_reached():
    model = Model("fall", {}, ("x",), lambda s, p, t: (-1 / s.x,))
    with pytest.raises(MotionError, match=r"could not be followed beyond t = 0\.5") as told:
        integrate(model, 1.0, (1.0,))
    assert type(told.value) is MotionError
    assert told.value.reached.t_end == pytest.approx(0.5, abs=1e-6)


# -- heyoka


@needs_heyoka
def test_a_second_run_close_to_a_verified_one_is_not_compared_again():
    system = prepared_model(second_order("fresh", {}, ("a",), lambda s, p, t: (-sin(s.a),)))
    first = Run(system, 0.0, 10.0, START, 1e-9)
    motion = first.by_name("taylor")
    assert not callable(motion.estimate)
    again = Run(system, 0.0, 10.0, START, 1e-9)
    motion = again.by_name("taylor")
    assert callable(motion.estimate)
    assert again.calls < first.calls
    assert 0 < motion.error <= 1e-9
    # with events each is
    events = (Event(lambda s, p, t: s.a),)
    assert not callable(Run(system, 0.0, 10.0, START, 1e-9, events).by_name("taylor").estimate)
    other = Run(system, 0.0, 10.0, (2.0, 0.0), 1e-9).by_name("taylor")
    assert not callable(other.estimate)


@needs_heyoka
def test_a_run_that_an_event_ended_early_does_not_vouch_for_the_whole_time():
    """Up to t = 1 it is accurate, to t = 40 no run can be."""
    model, start = lorenz(), (1.0, 1.0, 20.0)
    early = Event(lambda s, p, t: t - 1.0, terminal=True)
    assert integrate(model, 40.0, start, 1e-9, "taylor", early).error < 1e-9
    with pytest.raises(AccuracyError, match="forgets its start"):
        integrate(model, 40.0, start, 1e-9, "taylor")


@needs_heyoka
def test_progress_is_told_of_the_run_that_is_returned_only():
    parts = []
    run(t1=50.0, progress=parts.append).by_name("taylor")
    assert parts == sorted(parts)
    assert parts.count(1.0) == 1


class Series(Scripted):
    """A run of heyoka that is not made, with this error; it ends where it began."""

    def trajectory(self, method, tolerance, *more):
        found = super().trajectory(method, tolerance, *more)
        stepper = SimpleNamespace(start=(0.0, self.state))
        found.segments = [Segment(self.system, stepper, self.t0, self.t1, self.state)]
        return found

    def series_error(self, method, trajectory):
        self.compared(method, method.other(trajectory.tolerance), trajectory.tolerance)
        return self.error

    def calibrated(self, method):
        return "with all care"


def series(error, failing=None, system=None, **options):
    system = system or PreparedModel(PENDULUM)
    one = Series(system, 0.0, 10.0, START, 1e-9, **options)
    one.asked, one.beside, one.failing, one.error = [], [], failing, error
    return one, one.series(METHODS["taylor"])


@pytest.mark.parametrize(("error", "told"), [(1e-10, 3e-10), (1e-9, 1e-9)])
def test_a_series_that_is_accurate_enough_is_returned_and_vouches_for_others(error, told):
    one, motion = series(error)
    assert motion.error == pytest.approx(told)
    assert one.system.verified.covers(1e-9, 0.0, 10.0, START, START)
    again, motion = series(error, system=one.system)
    assert not again.beside
    assert motion.error() == pytest.approx(told)
    with_events, _ = series(error, system=one.system, events=(None,))
    assert with_events.beside


@pytest.mark.parametrize(("error", "failing"), [(1.01e-9, None), (math.nan, None), (0.0, "why")])
def test_a_series_that_is_not_accurate_or_stops_is_made_with_all_care(error, failing):
    one, motion = series(error, failing)
    assert motion == "with all care"
    assert not one.system.verified.runs


def test_a_series_is_compared_with_one_of_higher_order_beside_its_start(monkeypatch):
    taylor, one = METHODS["taylor"], Scripted(prepared_model(PENDULUM), 0.0, 10.0, START, 1e-9)
    one.beside, pair = [], []
    monkeypatch.setattr(
        control_run, "predicted_error", lambda *runs: pair.append([r.tolerance for r in runs[:2]])
    )
    one.series_error(taylor, SimpleNamespace(tolerance=1e-9))
    assert one.beside == [(taylor.other(1e-9), 1e-9, None, False, SIZE_SAMPLES)]
    assert pair == [[taylor.other(1e-9), 1e-9]]


# -- the closed form


SPRING = second_order(
    "spring",
    {},
    ("x",),
    lambda s, p, t: (-s.x,),
    exact=lambda s, p, t: (s.x * cos(t) + s.dx * sin(t), s.dx * cos(t) - s.x * sin(t)),
)


def test_a_closed_form_is_returned_with_its_error():
    motion = run(SPRING, 8.0, START, 1e-12, 5.0).by_name("exact")
    assert motion.end == pytest.approx({"x": math.cos(3.0), "dx": -math.sin(3.0)}, abs=1e-15)
    assert 0 < motion.error < 1e-14


def test_a_closed_form_that_gives_way_to_a_model_without_one_does_not_do():
    event = Event(lambda s, p, t: s.x, then=lambda s, p, t: (PENDULUM, (s.x, s.dx)))
    for rtol in (1e-9, 1e-15):  # also where it would not be accurate either
        with pytest.raises(ModelError, match="it becomes a model without one; take met") as told:
            run(SPRING, 8.0, START, rtol, events=(event,)).by_name("exact")
        assert type(told.value) is ModelError


def test_the_closed_forms_of_all_segments_are_judged():
    """The second has the phase of 1e9 s."""
    slow = second_order(
        "slow",
        {},
        ("x",),
        lambda s, p, t: (0.0 * s.x,),
        exact=lambda s, p, t: (s.x + t * s.dx, s.dx),
    )
    event = Event(lambda s, p, t: t - 1.0, then=lambda s, p, t: (SPRING, (1.0, 0.0)))
    with pytest.raises(AccuracyError, match="'slow' does not do: it is not accurate here") as told:
        run(slow, 1e9, START, events=(event,)).by_name("exact")
    assert told.value.reached.error > 1e-9
    assert run(slow, 10.0, START, events=(event,)).by_name("exact").t_end == 10.0


# -- a prepared series


@needs_heyoka
def test_an_end_that_is_wrong_is_not_verified(monkeypatch):
    system = prepared_model(
        second_order("fresh", {"n": 1.0}, ("a",), lambda s, p, t: (-p.n * sin(s.a),))
    )
    verify = verified_series(system, 1e-9, METHODS["taylor"])
    end = tuple(integrate(PENDULUM, 10.0, START, 1e-12).end.values())
    wrong = end[0] + 1e-8, end[1]
    assert not verify(10.0, START, wrong)
    assert not verify(10.0, START, (end[0], end[1] - 1e-8))
    assert verify(10.0, START, end)
    assert system.verified.covers(1e-9, 0.0, 10.0, START, end)
    monkeypatch.setattr(Run, "compared", None)  # it is not made again
    assert verify(10.0, START, end)


def test_a_prepared_series_is_compared_with_one_of_higher_order(monkeypatch):
    asked = []

    def compared(self, method, *more):
        asked.append(more)
        return SimpleNamespace(failed=ArithmeticError())

    monkeypatch.setattr(Run, "compared", compared)
    taylor, system = METHODS["taylor"], PreparedModel(PENDULUM)
    assert not verified_series(system, 1e-9, taylor)(10.0, START, START)
    level = level_of(1e-9 / 10**1.5)
    assert asked == [(taylor.other(level), level, None, False, SIZE_SAMPLES)]
    assert not system.verified.runs


@needs_heyoka
def test_a_prepared_series_is_not_trusted_through_a_pulse():
    pulse = lambda s, p, t: (exp(-(((t - 0.5) / 0.01) ** 2)),)
    system = prepared_model(Model("struck", {}, ("x",), pulse))
    verify = verified_series(system, 1e-9, METHODS["taylor"])
    assert not verify(4.0, (0.0,), (0.01 * math.sqrt(math.pi),))
    assert verify(0.2, (1.0,), (1.0,))


# -- what is said


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (
            3e-5,
            r"is about 3e-05, and rtol = 1e-09 was asked for; ask for rtol = 0.0001. The motion",
        ),
        (0.2, r"is large: no digit is certain, .*; the motion forgets its start; take a shorter"),
        (0.05, r"large: no digit is certain"),
        (math.inf, r"large: no digit is certain.*shorter time"),
        (math.nan, r"large: no digit is certain.*shorter time"),
        (0.049, r"about 0.05, .* ask for rtol = 0.1"),
    ],
)
def test_a_refusal_says_what_can_be_had(error, words):
    import re

    model = SimpleNamespace(name="any")
    motion = SimpleNamespace(error=error, t_end=3.25, method=METHODS["dop853"])
    text = Run(SimpleNamespace(model=model), 0.0, 3.25, START, 1e-9).too_inaccurate(motion)
    assert text.startswith("any, at t = 3.25: the error by method 'dop853' ")
    assert re.search(words, text)


def test_what_is_refused_is_there_with_its_error_above_what_was_asked():
    ill = second_order(
        "ill",
        {},
        ("x",),
        lambda s, p, t: (-s.x,),
        exact=lambda s, p, t: (s.x * cos(t), -s.x * sin(t)),
    )
    with pytest.raises(AccuracyError, match="form of 'ill' does not do: it is not acc") as told:
        integrate(ill, 1e9, START, 1e-9, method="exact")
    assert told.value.reached.error > 1e-9
    assert told.value.reached.t_end == 1e9


def test_sqrt_of_a_square_is_followed_by_runge_kutta():
    drag = Model("drag", {}, ("v",), lambda s, p, t: (-1.0 - sqrt(s.v * s.v) * s.v,))
    motion = integrate(drag, 3.0, (1.0,))
    assert motion.method.name == "dop853"
    assert motion.end["v"] == pytest.approx(-math.tanh(3.0 - math.pi / 4), abs=1e-9)


@pytest.mark.parametrize("ulps", [1, 2, 3, 11])
def test_a_time_of_a_few_roundings_ends(ulps):
    """It hung: a step that is less than a rounding of the time does not change it."""
    drift = Model("drift", {}, ("x", "v"), lambda s, p, t: (s.v, 0.0 * s.v))
    begin, end = 3.0 - ulps * 2.0**-51, 3.0 + ulps * 2.0**-51
    try:
        motion = integrate(drift, (begin, end), (0.0, 1.0), 0.5, "dop853")
    except AccuracyError as refused:
        motion = refused.reached
    assert motion.end["x"] == pytest.approx(end - begin, rel=0.5)


def test_the_error_that_is_told_has_more_safety_but_is_not_above_what_was_asked():
    assert told(1e-9, 1e-6) == pytest.approx(3e-9)
    assert told(5e-7, 1e-6) == 1e-6
    assert told(2e-6, 1e-6) == 2e-6  # refused: as it is
    assert math.isnan(told(math.nan, 1e-6))
