"""Which method one integration takes, how its error is predicted, and what is said if that is too
large.
"""

import importlib.util
import math
from types import SimpleNamespace

import pytest

from newton_euler import Model, exp, integrate, sin, sqrt
from newton_euler.motion import ModelError, second_order
from newton_euler.motion.control.run import (
    HEYOKA_BREAK_EVEN,
    IRREGULAR,
    REGULAR,
    ROUND_OFF,
    ROUND_OFF_OF_RATES,
    SAFETY,
    SERIES_ROUND_OFF,
    SERIES_SAFETY,
    AccuracyError,
    Run,
    check,
    predicted,
    predicted_error,
    span,
    told,
    usable,
    verified_series,
)
from newton_euler.motion.events import Event
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.solution import MotionError

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


@pytest.mark.parametrize("t", ["x", None, (1.0,), (1.0, 2.0, 3.0), (1.0, None)], ids=str)
def test_a_time_that_is_none_is_said(t):
    with pytest.raises(ModelError, match=r"time at which to end, or \(from, to\)"):
        span(t)


@pytest.mark.parametrize(
    "t", [0.0, -1.0, 0, (1.0, 1.0), (2.0, 1.0), math.inf, math.nan, (0.0, math.inf), (math.nan, 1)]
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


@pytest.mark.parametrize("rtol", [0.0, -1e-9, 1.0, 2, math.nan, "1e-9", None])
def test_an_rtol_lies_between_0_and_1(rtol):
    with pytest.raises(ModelError, match="it lies below 1"):
        check(rtol, "auto")
    check(rtol, "verlet", step=0.1)  # with a fixed step it does not matter


@pytest.mark.parametrize("step", [0.0, -0.1, math.nan])
def test_a_step_is_positive(step):
    with pytest.raises(ModelError, match="the step is a positive time"):
        check(1e-6, "verlet", step=step)


def test_a_method_and_events_are_what_they_must_be():
    with pytest.raises(ModelError, match="no method 'euler'; take 'auto' or one of exact, taylor"):
        check(1e-6, "euler")
    with pytest.raises(ModelError, match=r"events are made by Event"):
        check(1e-6, "auto", [lambda s, p, t: s.a])
    check(1e-6, "auto", [Event(lambda s, p, t: s.a)])


def test_a_method_that_cannot_be_used_says_why():
    assert usable("dop853", prepared_model(PENDULUM)) is METHODS["dop853"]
    with pytest.raises(ModelError, match="'exact' cannot be used: no exact solution of 'pendulum'"):
        usable("exact", prepared_model(PENDULUM))


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
    # of equal tolerances neither is
    assert predicted(1e-8, 1.0, 1e-12) == pytest.approx(SAFETY * 1e-8, rel=1e-5)


def test_round_off_grows_as_the_root_of_the_number_of_steps():
    for ratio, one in ((1e-3, ROUND_OFF), (54.0, SERIES_ROUND_OFF)):
        assert predicted(0.0, ratio, 0.0, True, 0) == one
        assert predicted(0.0, ratio, 0.0, True, 300) == pytest.approx(2 * one)
        assert predicted(0.0, ratio, 0.0, True, 10**6) == pytest.approx(100 * one, rel=1e-3)


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


def test_with_events_it_starts_at_the_same_place():
    """It may lie on the surface of one."""
    one = run(state=(1.0, 2.0), events=(Event(lambda s, p, t: s.a - 1.0),))
    assert start_of(one.compared(METHODS["dop853"], 1e-4, 1e-7)) == (1.0, 2.0)


def test_all_runs_are_counted_in_the_cost():
    one = run()
    motion = one.by_name("dop853")
    assert motion.cost.calls == one.calls > motion.segments[0].stepper.calls
    assert motion.cost.seconds > 0
    assert run(preparing=0.5).by_name("dop853").cost.preparing == 0.5


# -- auto


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


def test_auto_returns_the_more_accurate_of_what_it_was_refused():
    """A motion that no float can follow: the error is that of .reached."""
    lorenz = Model(
        "Lorenz",
        {},
        ("x", "y", "z"),
        lambda s, p, t: (10 * (s.y - s.x), s.x * (28 - s.z) - s.y, s.x * s.y - 8 / 3 * s.z),
    )
    with pytest.raises(AccuracyError, match="the motion forgets its start") as told:
        integrate(lorenz, 60.0, (1.0, 1.0, 20.0))
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
def test_an_end_that_is_wrong_is_not_verified():
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
    assert verify(10.0, START, end)


@needs_heyoka
def test_a_prepared_series_is_not_trusted_through_a_pulse():
    pulse = lambda s, p, t: (exp(-(((t - 5.0) / 0.01) ** 2)),)
    system = prepared_model(Model("struck", {}, ("x",), pulse))
    verify = verified_series(system, 1e-9, METHODS["taylor"])
    assert not verify(10.0, (0.0,), (0.01 * math.sqrt(math.pi),))
    assert verify(4.0, (1.0,), (1.0,))


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
    from newton_euler import cos

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
