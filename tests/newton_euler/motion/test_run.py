"""Which method one integration takes, how its tolerance is refined, and what a refusal says."""

import importlib.util
import itertools
import math
from types import SimpleNamespace

import pytest

from newton_euler import Model, cos, integrate, sin, sqrt
from newton_euler.motion import ModelError, second_order
from newton_euler.motion import run as run_module
from newton_euler.motion.error_estimates import (
    REGULAR,
    ROUND_OFF_OF_RATES,
    SAFETY,
    SERIES_SAFETY,
    error_by_comparison,
)
from newton_euler.motion.events import Event, EventError
from newton_euler.motion.methods.base import MAX_STEPS
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.run import FEW_STEPS, HEYOKA_BREAK_EVEN, Run, usable
from newton_euler.motion.solution import AccuracyError, MotionError

HEYOKA = importlib.util.find_spec("heyoka") is not None
needs_heyoka = pytest.mark.skipif(not HEYOKA, reason="heyoka is not installed")
PENDULUM = second_order("pendulum", {}, ("a",), lambda s, p, t: (-sin(s.a),))
START = (1.0, 0.0)


def run(model=PENDULUM, t1=10.0, state=START, rtol=1e-9, t0=0.0, **options):
    return Run(prepared_model(model), t0, t1, state, rtol, **options)


def test_a_method_that_cannot_be_used_says_why():
    assert usable("dop853", prepared_model(PENDULUM)) is METHODS["dop853"]
    with pytest.raises(ModelError, match="'exact' cannot be used: no exact solution of 'pendulum'"):
        usable("exact", prepared_model(PENDULUM))
    driven = Model("driven", {}, ("x",), lambda s, p, t: (t,), exact=lambda s, p, t: (s.x + t * t,))
    assert usable("exact", prepared_model(driven)) is METHODS["exact"]
    with pytest.raises(ModelError, match="its exact solution starts at t = 0"):
        usable("exact", prepared_model(driven), 1.0)


def test_a_fixed_step_needs_a_method_that_has_one_and_has_no_error_estimate():
    motion = run(step=0.125).by_name("yoshida4")
    assert math.isnan(motion.error)
    assert motion.segments[0].stepper.step_times[1] == 0.125
    with pytest.raises(ModelError, match="needs a method by name"):
        run(step=0.1).by_name("auto")
    with pytest.raises(ModelError, match="'scipy LSODA' has no fixed step"):
        run(step=0.1).by_name("scipy LSODA")


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
    assert 20 < ROUND_OFF_OF_RATES / 2.0**-52 < 30
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


ORBIT = second_order(
    "orbit",
    {},
    ("x", "y"),
    lambda s, p, t: (
        -s.x / sqrt(s.x * s.x + s.y * s.y) ** 3,
        -s.y / sqrt(s.x * s.x + s.y * s.y) ** 3,
    ),
)
PERIAPSIS = 0.7, 0.0, 0.0, math.sqrt(1.3 / 0.7)  # of e = 0.3; after whole turns it is here again


class Recorded(Run):
    """A run that records the tolerances of its trajectories, and of those it compares with."""

    def trajectory(self, method, tolerance, *more):
        self.fine.append(tolerance)
        return super().trajectory(method, tolerance, *more)

    def compared(self, method, tolerance, *more):
        self.others.append(tolerance)
        return super().compared(method, tolerance, *more)


def recorded(name, rtol, model=ORBIT, start=PERIAPSIS, t1=6 * math.pi):
    """The run, and its motion, also one that is refused."""
    one = Recorded(prepared_model(model), 0.0, t1, start, rtol)
    one.fine, one.others = [], []
    try:
        return one, one.by_name(name)
    except MotionError as refused:
        return one, refused.reached


def test_an_error_that_is_small_enough_needs_no_other_run():
    one, motion = recorded("dop853", 1e-9, PENDULUM, START, 10.0)
    assert len(one.fine) == len(one.others) == 1
    assert 0 < motion.error < 1e-9


@pytest.mark.parametrize(("method", "rtol", "compared"), [("dop853", 1e-6, 1), ("verlet", 1e-4, 2)])
def test_the_tolerance_is_refined_until_the_error_is_small_enough(method, rtol, compared):
    """A method of fixed step is compared with another run each time."""
    one, motion = recorded(method, rtol)
    assert len(one.fine) == 2
    assert one.fine[1] <= 0.1 * one.fine[0]
    assert len(one.others) == compared
    assert motion.error <= rtol
    assert max(abs(x - y) for x, y in zip(motion.end.values(), PERIAPSIS, strict=True)) < rtol


@pytest.mark.parametrize(
    ("rtol", "t1", "least", "most"),
    [(1e-6, 6 * math.pi, 0.0, 0.1), (1e-3, 400 * math.pi, 1e-3, 1e-3)],
)
def test_the_next_tolerance_aims_at_half_of_the_rtol_within_limits(rtol, t1, least, most):
    """After 200 turns the first runs are so far apart that the limit decides."""
    method, one = METHODS["dop853"], run(ORBIT, t1, PERIAPSIS, rtol)
    tolerance = min(rtol / method.tolerance_ratio, method.max_tolerance)
    before = one.compared(method, method.other(tolerance), tolerance)
    error = error_by_comparison(before, one.trajectory(method, tolerance, before.sizes()), method)
    first, second = recorded("dop853", rtol, t1=t1)[0].fine[:2]
    assert first == tolerance
    assert second / first == pytest.approx(min(max(rtol / 2 / error, least), most), rel=1e-6)


@needs_heyoka
def test_a_series_for_comparison_knows_the_sizes_of_the_states_on_the_way():
    """The velocity of half a swing is zero at both ends."""
    found = run(SPRING, math.pi).compared(METHODS["taylor"], 1e-12, 1e-10)
    assert found.segments[0].stepper.scales == pytest.approx((1.0, 1.0), rel=1e-2)


def test_at_the_least_tolerance_the_motion_is_refused_with_its_error():
    one, motion = recorded("dop853", 1e-13)
    assert one.fine[-1] == METHODS["dop853"].min_tolerance
    assert one.others[-1] == 10 * one.fine[-1]
    assert motion.error > 1e-13
    apart = max(abs(x - y) for x, y in zip(motion.end.values(), PERIAPSIS, strict=True))
    assert apart <= motion.error


def test_a_run_that_fails_is_not_repeated():
    fall = Model("fall", {}, ("x",), lambda s, p, t: (-1 / s.x,))
    one, motion = recorded("dop853", 1e-9, fall, (1.0,), 1.0)
    assert len(one.fine) == 1
    assert motion.t_end == pytest.approx(0.5, abs=1e-6)


def test_a_motion_that_would_take_too_many_steps_is_not_begun_a_second_time():
    one = run(t1=1e6, max_steps=1e4)
    with pytest.raises(MotionError, match="steps would be needed to reach t = 1e") as refused:
        one.by_name("dop853")
    assert refused.value.reached.cost.calls == refused.value.reached.segments[0].stepper.calls
    assert math.isnan(refused.value.reached.error)


@pytest.fixture
def clock(monkeypatch):
    """A function that sets the clock: it advances by this many seconds each time it is read."""

    def set_to(step):
        times = itertools.count(1e5, step)
        monkeypatch.setattr(run_module, "perf_counter", lambda: next(times))

    return set_to


NUMBERS = itertools.count(1)


def fresh():
    """A model of which no other test has made an integrator."""
    n = next(NUMBERS)
    return second_order("fresh", {}, ("a",), lambda s, p, t: (-sin(s.a) - n * 1e-9,))


@needs_heyoka
@pytest.mark.parametrize(("seconds", "method"), [(0.2, "dop853"), (0.22, "taylor")])
def test_heyoka_takes_over_where_the_first_run_shows_that_the_second_would_be_slow(
    clock, seconds, method
):
    """A thousandth of the tolerance takes 1000^(1/8) = 2.37 times as long, and half a second pays
    for the compilation.
    """
    clock(seconds)
    assert run(fresh()).by_name("auto").method.name == method


def test_where_heyoka_fails_the_second_run_is_made(clock, monkeypatch):
    def fails(self, method):
        raise MotionError("no series", None)

    clock(9.0)
    monkeypatch.setattr(Run, "by", fails)
    motion = run(fresh()).calibrated(METHODS["dop853"], True)
    assert motion.method.name == "dop853"
    assert motion.error <= 1e-9


def test_the_seconds_of_all_runs_are_kept_for_the_next(clock):
    clock(0.125)
    one = run(fresh())
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
def test_of_several_refusals_the_most_accurate_is_raised(taylor, dop853, words):
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
def test_only_a_series_that_sees_all_of_the_rates_is_not_calibrated(
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
def test_auto_begins_with_heyoka_once_its_compilation_has_paid_off():
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
def test_auto_takes_heyoka_for_what_is_too_tight_for_runge_kutta():
    least = METHODS["dop853"].min_rtol
    motion = run(fresh(), 2.0, rtol=0.9 * least).by_name("auto")
    assert motion.method.name == "taylor"
    assert run(fresh(), 5.0, rtol=1e-9).by_name("auto").method.name == "dop853"


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
    with pytest.raises(AccuracyError, match="the motion forgets its start") as refused:
        integrate(lorenz(), 60.0, (1.0, 1.0, 20.0))
    assert refused.value.reached.error > 0.05
    assert refused.value.reached.t_end == 60.0


@needs_heyoka
def test_where_rates_have_no_value_auto_says_so_with_what_was_reached():
    model = Model("fall", {}, ("x",), lambda s, p, t: (-1 / s.x,))
    with pytest.raises(MotionError, match=r"could not be followed beyond t = 0\.5") as refused:
        integrate(model, 1.0, (1.0,))
    assert type(refused.value) is MotionError
    assert refused.value.reached.t_end == pytest.approx(0.5, abs=1e-6)


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
def test_progress_is_that_of_the_returned_run_only():
    parts = []
    run(t1=50.0, progress=parts.append).by_name("taylor")
    assert parts == sorted(parts)
    assert parts.count(1.0) == 1


@needs_heyoka
def test_a_series_that_is_not_accurate_is_calibrated_and_vouches_for_nothing(monkeypatch):
    errors = iter([1e-8, 1e-10])
    monkeypatch.setattr(run_module, "error_by_comparison", lambda *_: next(errors))
    one = run(fresh())
    assert one.by_name("taylor").error == pytest.approx(3e-10)
    assert not one.system.verified.runs


@needs_heyoka
def test_a_series_that_stops_is_refused():
    fall = Model("fall", {}, ("x",), lambda s, p, t: (-1 / s.x,))
    one = run(fall, 1.0, (1.0,))
    with pytest.raises(MotionError, match="could not be followed beyond"):
        one.by_name("taylor")
    assert not one.system.verified.runs


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


def test_a_closed_form_that_gives_way_to_a_model_without_one_is_refused():
    event = Event(lambda s, p, t: s.x, then=lambda s, p, t: (PENDULUM, (s.x, s.dx)))
    for rtol in (1e-9, 1e-15):  # also where it would not be accurate either
        with pytest.raises(
            ModelError, match="ends where it becomes a model without one"
        ) as refused:
            run(SPRING, 8.0, START, rtol, events=(event,)).by_name("exact")
        assert type(refused.value) is ModelError


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
    with pytest.raises(AccuracyError, match="'slow' is not accurate here") as refused:
        run(slow, 1e9, START, events=(event,)).by_name("exact")
    assert refused.value.reached.error > 1e-9
    assert run(slow, 10.0, START, events=(event,)).by_name("exact").t_end == 10.0


# -- refusals


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (
            3e-5,
            r"is about 3e-05, and rtol = 1e-09 was requested; ask for rtol = 0.0001. The motion",
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
    text = Run(SimpleNamespace(model=model), 0.0, 3.25, START, 1e-9).refusal(motion)
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
    with pytest.raises(AccuracyError, match="form of 'ill' is not accurate here") as refused:
        integrate(ill, 1e9, START, 1e-9, method="exact")
    assert refused.value.reached.error > 1e-9
    assert refused.value.reached.t_end == 1e9


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
