"""Which method one integration takes, how its tolerance is refined, and what a refusal says."""

import itertools
import math
import re
from dataclasses import replace
from types import SimpleNamespace

import pytest

from newton_euler import Model, cos, exp, integrate, sin, tanh, where
from newton_euler.motion import ModelError, second_order
from newton_euler.motion import run as run_module
from newton_euler.motion.error_estimates import REGULAR, ROUND_OFF_OF_RATES, SAFETY, SERIES_SAFETY
from newton_euler.motion.events import Event, EventError
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.run import FEW_STEPS, HEYOKA_BREAK_EVEN, Run, usable
from newton_euler.motion.solution import AccuracyError, MotionError
from tests.models import DRIFT, FALL, kepler, needs_heyoka, oscillator

PENDULUM = second_order("pendulum", {}, ("a",), lambda s, p, t: (-sin(s.a),))
START = (1.0, 0.0)


def run(model=PENDULUM, t1=10.0, state=START, rtol=1e-9, t0=0.0, **options):
    return Run(prepared_model(model), t0, t1, state, rtol, **options)


def test_a_method_that_cannot_be_used_says_why_and_a_fixed_step_needs_one_that_has_it():
    assert usable("dop853", prepared_model(PENDULUM)) is METHODS["dop853"]
    with pytest.raises(ModelError, match="'exact' cannot be used: no exact solution of 'pendulum'"):
        usable("exact", prepared_model(PENDULUM))
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


@pytest.mark.parametrize(
    ("coarse", "part", "rel"),
    [(1e-4, 1 / (SAFETY * 1e-3**REGULAR), 1e-2), (1e-9, 1 / SERIES_SAFETY, 0.0)],
)
def test_the_run_that_another_is_compared_with_starts_slightly_displaced(coarse, part, rel):
    """This puts the round-off of the rates into the prediction: the shift times the factor of the
    prediction equals it. Every second state is shifted the other way.
    """
    assert 20 < ROUND_OFF_OF_RATES / 2.0**-52 < 30
    start = (1.0, 2.0, 1.0, 2.0, 1.0)
    still = Model("still", {}, tuple("abcde"), lambda s, p, t: (0.0 * s.a,) * 5)
    one = run(still, state=start)
    found = one.compared(METHODS["dop853"], coarse, 1e-7)
    shift = [a / b - 1 for a, b in zip(start_of(found), start, strict=True)]
    part *= ROUND_OFF_OF_RATES
    assert shift == pytest.approx([part, -part, part, -part, part], rel=rel, abs=3e-16)
    assert found.calls == one.calls > 0
    assert one.state == start


def test_with_events_it_starts_at_the_same_point():
    """The start may lie on the surface of an event."""
    one = run(state=(1.0, 2.0), events=(Event(lambda s, p, t: s.a - 1.0),))
    assert start_of(one.compared(METHODS["dop853"], 1e-4, 1e-7)) == (1.0, 2.0)


def test_all_runs_are_counted_in_the_cost():
    one = run()
    motion = one.by_name("dop853")
    assert motion.cost.calls == one.calls > motion.segments[0].stepper.calls
    assert motion.cost.preparing == 0.0
    assert run(preparing=0.5).by_name("dop853").cost.preparing == 0.5


# -- until it is accurate enough


ORBIT = kepler()
PERIAPSIS = 0.7, 0.0, 0.0, math.sqrt(1.3 / 0.7)  # e = 0.3; back here after whole orbits


def reached(name, rtol, model=ORBIT, start=PERIAPSIS, t1=6 * math.pi, t0=0.0):
    """The motion, refused or not, and the cost of all runs over that of the one returned."""
    try:
        motion = run(model, t1, start, rtol, t0).by_name(name)
    except MotionError as refused:
        motion = refused.reached
    return motion, motion.cost.calls / sum(part.stepper.calls for part in motion.segments)


@pytest.mark.parametrize(
    ("method", "rtol", "turns", "least", "most"),
    [
        ("dop853", 1e-9, 1, 1.3, 1.7),  # one other run
        ("dop853", 1e-6, 3, 2.0, 3.0),  # one refinement
        ("dop853", 1e-3, 200, 2.0, 3.0),  # from two coarse runs that are far apart
        ("verlet", 1e-4, 3, 1.3, 1.6),  # fixed step: each run is compared with another one
        ("dop853", 1e-13, 3, 2.0, 3.0),  # refused
    ],
)
def test_the_tolerance_is_refined_until_the_error_is_small_enough(method, rtol, turns, least, most):
    motion, work = reached(method, rtol, t1=2 * math.pi * turns)
    assert least < work < most
    off = max(abs(x - y) for x, y in zip(motion.end.values(), PERIAPSIS, strict=True))
    assert off < motion.error
    assert (motion.error <= rtol) == (rtol > 1e-13)
    assert motion.error > rtol / 1e4


def test_a_state_that_begins_by_round_off_alone_does_not_stop_the_finer_run():
    def rates(s, p, t):
        u = tanh(10 * (s.x - 5.61))
        return p.v, 17.0 * u * (1 - u * u)

    motion = integrate(Model("hill", {"v": 1.7}, ("x", "q"), rates), 6.0, (0.0, 0.0), 1e-12)
    assert motion.at(3.3)["q"] == pytest.approx(-0.5, abs=1e-11)


def test_what_no_tolerance_makes_smaller_is_tried_a_few_times():
    """The round-off of the time at t = 1e9 limits the accuracy; a failed run is not repeated."""
    driven = second_order("driven", {}, ("x",), lambda s, p, t: (sin(2 * t) - s.x,))
    motion, work = reached("dop853", 1e-6, driven, START, 1e9 + 1.0, 1e9)
    assert 1e-6 < motion.error < 1e-3
    assert 1 < work < 3
    motion, work = reached("dop853", 1e-9, FALL, (1.0,), 1.0)
    assert work < 2
    assert motion.t_end == pytest.approx(0.5, abs=1e-6)


@needs_heyoka
def test_a_series_for_comparison_knows_the_sizes_of_the_states_on_the_way():
    """The velocity is zero at both ends of half a swing."""
    found = run(SPRING, math.pi).compared(METHODS["taylor"], 1e-12, 1e-10)
    assert found.segments[0].stepper.scales == pytest.approx((1.0, 1.0), rel=1e-2)


def test_a_motion_that_would_take_too_many_steps_is_not_begun_a_second_time():
    one = run(t1=1e6, max_steps=1e4)
    with pytest.raises(MotionError, match="steps would be needed to reach t = 1e") as refused:
        one.by_name("dop853")
    assert refused.value.reached.cost.calls == refused.value.reached.segments[0].stepper.calls
    assert math.isnan(refused.value.reached.error)


@pytest.mark.one_in(3)
@needs_heyoka
@pytest.mark.parametrize("method", ["taylor", "auto"])
@pytest.mark.parametrize(("t", "samples"), [(2e5, None), (2e5, 33), (6e4 * math.pi, None)])
def test_errors_of_many_steps_add_up_so_a_long_motion_has_the_best_steps(method, t, samples):
    """This includes whole periods, where the speed is zero at equal parts of the time."""
    model = second_order("spring", {"k": 1.0}, ("x",), lambda s, p, t: (-p.k * s.x,))
    one = run(model, t, (1.0, 0.0), samples=samples, rtol=1e-6)
    motion = one.by_name(method)
    assert one.long
    assert motion.method.name == "taylor"
    assert motion.end["x"] == pytest.approx(math.cos(t), abs=1e-7)
    assert motion.at(t / 2)["x"] == pytest.approx(math.cos(t / 2), abs=1e-7)


@needs_heyoka
def test_where_no_method_is_accurate_after_a_long_time_no_other_is_tried():
    one = run(second_order("own", {}, ("x",), lambda s, p, t: (-sin(s.x),)), 2e5, (2.0, 0.0))
    one.rtol = 1e-12
    with pytest.raises(AccuracyError):
        one.by_name("auto")
    assert one.calls < 1e8  # DOP853 would need 12 calls for each of 1e7 steps


@pytest.fixture
def clock(monkeypatch):
    """A function that sets how many seconds the clock advances each time it is read."""

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
def test_heyoka_takes_over_where_the_first_run_shows_the_second_to_be_slow(clock, seconds, method):
    """A thousandth of the tolerance takes 1000^(1/8) = 2.37 times as long, and half a second pays
    for the compilation.
    """
    clock(seconds)
    assert run(fresh()).by_name("auto").method.name == method


def test_seconds_begin_with_the_run_and_are_kept_for_the_next(clock):
    clock(0.125)
    one = run(fresh())
    before = one.system.traced.seconds
    one.calibrated(METHODS["dop853"])
    assert one.system.traced.seconds == before + 0.125
    clock(0.5)
    one = run(started=99_000.0)
    assert one.motion(one.trajectory(METHODS["dop853"], 1e-6), METHODS["dop853"], 0.0).cost == (
        1000.0,
        0.0,
        one.calls,
    )


# -- auto


class Auto(Run):
    """A run whose methods have given outcomes: {name: a motion, or what the method raises}."""

    def candidates(self):
        names = [name.split() for name in self.outcomes if name != "exact"]
        return [(METHODS[name], bool(watched)) for name, *watched in names]

    def by(self, method):
        return self.outcome(method.name)

    def calibrated(self, method, heyoka=False):
        return self.outcome(method.name + " watched" * heyoka)

    def outcome(self, name):
        self.tried.append(name)
        if isinstance(self.outcomes[name], Exception):
            raise self.outcomes[name]
        return name


def auto(outcomes):
    exact = (lambda s, p, t: (s.a + s.da * t, s.da)) if "exact" in outcomes else None
    model = second_order("free", {}, ("a",), lambda s, p, t: (0.0 * s.a,), exact=exact)
    one = Auto(prepared_model(model), 0.0, 1.0, START, 1e-9)
    one.outcomes, one.tried = outcomes, []
    return one


def inaccurate(error):
    return AccuracyError(f"error {error}", SimpleNamespace(error=error))


def stopped(error):
    return MotionError(f"stopped with {error}", SimpleNamespace(error=error))


@pytest.mark.parametrize(
    ("first", "steps", "second"),
    [
        ({"exact": 1}, math.inf, {"dop853 watched": 1}),
        ({"dop853 watched": 1}, math.inf, {"taylor": 1}),
        ({"exact": inaccurate(1e-3), "dop853 watched": 1}, FEW_STEPS, {"taylor": 1}),
        ({"exact": ModelError("no value"), "dop853 watched": 1}, math.inf, {"taylor": 1}),
        ({"dop853 watched": inaccurate(1e-3), "taylor": 1}, math.inf, {}),
        ({"taylor": inaccurate(1e-3), "dop853": 1}, math.inf, {}),
        ({"taylor": stopped(0.1), "dop853": 1}, math.inf, {}),
        ({"exact": inaccurate(1e-3), "dop853 watched": stopped(0.1), "taylor": 1}, FEW_STEPS, {}),
    ],
    ids=["closed form", "none", "inaccurate one", "one without a value", "inaccurate Runge-Kutta",
         "inaccurate series", "series that stops", "Runge-Kutta that stops after an inaccurate one"],
)  # fmt: skip
def test_auto_goes_on_until_a_method_is_accurate(first, steps, second):
    """After a closed form that is not accurate, only a few steps are tried."""
    one = auto(first | second)
    assert [one.by_name("auto")] == one.tried[-1:]
    assert one.tried == list(first)
    assert one.max_steps == steps


@pytest.mark.parametrize(
    ("outcomes", "tried", "words"),
    [
        ({"exact": EventError("no number"), "dop853": 1}, 1, "no number"),
        ({"dop853 watched": stopped(0.1), "taylor": 1}, 1, r"stopped with 0\.1"),
        # of several refusals the most accurate is raised
        ({"taylor": inaccurate(1e-3), "dop853": inaccurate(1e-5)}, 2, "error 1e-05"),
        ({"taylor": inaccurate(1e-5), "dop853": inaccurate(1e-3)}, 2, "error 1e-05"),
        ({"taylor": inaccurate(1e-3), "dop853": stopped(1e-5)}, 2, r"error 0\.001"),
        ({"taylor": stopped(1e-5), "dop853": inaccurate(1e-3)}, 2, r"error 0\.001"),
        ({"taylor": stopped(0.2), "dop853": stopped(0.1)}, 2, r"stopped with 0\.1"),
    ],
)
def test_auto_refuses_what_no_method_would_mend_and_names_the_most_accurate(outcomes, tried, words):
    one = auto(outcomes)
    with pytest.raises((MotionError, EventError), match=words):
        one.by_name("auto")
    assert len(one.tried) == tried


def test_after_an_inaccurate_closed_form_a_long_motion_is_refused_after_few_steps():
    off = lambda s, p, t: (1.01 * s.a * cos(t), 1.01 * s.da)
    swing = second_order("swing", {}, ("a",), lambda s, p, t: (-s.a + 0 * abs(s.a),), exact=off)
    with pytest.raises(AccuracyError, match="'swing' is not accurate here"):
        run(swing, 1e6).by_name("auto")
    one = run(swing, 1e6, max_steps=FEW_STEPS)
    with pytest.raises(MotionError, match=r"steps would be needed .*; 1e\+05 are possible"):
        one.by_name("dop853")


def candidates(rtol=1e-9, hazards=(), kinks=(), integrators=(), seconds=0.0):
    traced = SimpleNamespace(
        hazards=hazards,
        kinks=kinks,
        inner=(),
        integrators=dict.fromkeys(integrators),
        seconds=seconds,
    )
    system = SimpleNamespace(traced=traced, model=SimpleNamespace(name="any"))
    one = Run(system, 0.0, 1.0, START, rtol)
    return [(method.name, heyoka) for method, heyoka in one.candidates()]


FIRST, SECOND = [("dop853", True), ("taylor", False)], [("taylor", False), ("dop853", False)]


@needs_heyoka
@pytest.mark.parametrize(
    ("options", "found"),
    [
        ({}, FIRST),
        ({"seconds": HEYOKA_BREAK_EVEN}, FIRST),
        ({"seconds": 1.01 * HEYOKA_BREAK_EVEN}, SECOND),
        ({"integrators": ["compiled"]}, SECOND),
        ({"hazards": ["sqrt"], "seconds": 9.0}, [("dop853", False)]),
        ({"kinks": ["where"], "seconds": 9.0}, [("dop853", False)]),
    ],
)
def test_auto_begins_with_heyoka_once_its_compilation_pays_unless_a_series_is_blind(options, found):
    assert candidates(**options) == found


@needs_heyoka
def test_what_is_too_tight_for_runge_kutta_and_has_kinks_is_refused():
    words = r"rtol = 1e-14 needs heyoka, .* least is 1e-13; the rates"
    with pytest.raises(ModelError, match=words):
        candidates(1e-14, kinks=["where"])


@needs_heyoka
def test_auto_takes_heyoka_for_what_is_too_tight_for_runge_kutta():
    least = METHODS["dop853"].min_rtol
    assert run(fresh(), 2.0, rtol=0.9 * least).by_name("auto").method.name == "taylor"
    assert run(fresh(), 5.0, rtol=1e-9).by_name("auto").method.name == "dop853"


def test_auto_without_heyoka_is_runge_kutta(monkeypatch):
    from newton_euler.motion.methods import table

    monkeypatch.setattr(table, "installed", lambda: False)
    assert candidates(seconds=9.0) == [("dop853", False)]
    with pytest.raises(ModelError, match=r"needs heyoka, .* not installed"):
        candidates(1e-14)


def lorenz():
    """A model whose motions forget their starts within some tens of seconds."""
    rates = lambda s, p, t: (10 * (s.y - s.x), s.x * (28 - s.z) - s.y, s.x * s.y - 8 / 3 * s.z)
    return Model("Lorenz", {}, ("x", "y", "z"), rates)


def test_auto_raises_the_more_accurate_of_its_refusals():
    """No float can follow this motion: the reported error is that of .reached."""
    with pytest.raises(AccuracyError, match="the motion forgets its start") as refused:
        integrate(lorenz(), 60.0, (1.0, 1.0, 20.0))
    assert refused.value.reached.error > 0.05
    assert refused.value.reached.t_end == 60.0


# -- heyoka


@needs_heyoka
def test_a_second_run_close_to_a_verified_one_is_not_compared_again():
    model = fresh()
    first, again = run(model), run(model)
    assert not callable(first.by_name("taylor").estimate)
    motion = again.by_name("taylor")
    assert callable(motion.estimate)
    assert again.calls < first.calls
    assert 0 < motion.error <= 1e-9
    # with events each run is compared
    events = (Event(lambda s, p, t: s.a),)
    for other in (run(model, events=events), run(model, state=(2.0, 0.0))):
        assert not callable(other.by_name("taylor").estimate)


@needs_heyoka
def test_a_run_that_an_event_ended_early_does_not_vouch_for_the_whole_time():
    """Up to t = 1 the run is accurate; up to t = 40 no run can be."""
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
    errors = iter([1e-8, 1e-8, 1e-10])  # the second by the sizes on the way
    monkeypatch.setattr(run_module, "error_by_comparison", lambda *_: next(errors))
    one = run(fresh())
    assert one.by_name("taylor").error == pytest.approx(3e-10)
    assert not one.system.verified.runs


@needs_heyoka
@pytest.mark.parametrize("rtol", [1e-4, 1e-9])
def test_a_state_that_happens_to_be_small_at_both_ends_is_judged_by_its_size_on_the_way(rtol):
    """After ten periods the speed is that of round-off: by its ends it were small by
    cancellation. A prepared run vouches for itself, though its start is a list.
    """
    model, t, start = oscillator().changed(k=1.0), 20 * math.pi, [1.0, 0.0]
    motion = integrate(model, t, start, rtol, "taylor")
    system = motion.segments[0].system
    assert abs(motion.end["dx"]) < motion.error <= rtol
    assert rtol in system.verified.runs
    system.verified.add(rtol, 0.0, t, tuple(start), motion.segments[0].x1, rtol)
    assert run_module.fast_run(system, METHODS["taylor"], rtol)(t, start)
    assert integrate(model, t, start, rtol, "taylor").error <= rtol


@needs_heyoka
def test_a_series_that_stops_is_refused():
    one = run(replace(FALL), 1.0, (1.0,))
    with pytest.raises(MotionError, match="could not be followed beyond"):
        one.by_name("taylor")
    assert not one.system.verified.runs


# -- the closed form


SPRING = oscillator().changed(k=1.0)


def test_a_closed_form_is_returned_with_its_error_or_refused_where_it_gives_way():
    motion = run(SPRING, 8.0, START, 1e-12, 5.0).by_name("exact")
    assert motion.end == pytest.approx({"x": math.cos(3.0), "dx": -math.sin(3.0)}, abs=1e-15)
    assert 0 < motion.error < 1e-14
    event = Event(lambda s, p, t: s.x, then=lambda s, p, t: (PENDULUM, (s.x, s.dx)))
    for rtol in (1e-9, 1e-15):  # even where the closed form would not be accurate either
        with pytest.raises(ModelError, match="it becomes a model without one; take") as refused:
            run(SPRING, 8.0, START, rtol, events=(event,)).by_name("exact")
        assert type(refused.value) is ModelError
    assert run(SPRING, 8.0, START, events=(event,)).by_name("auto").error < 1e-9


def test_the_closed_forms_of_all_segments_are_judged():
    """The second segment has the phase of 1e9 s."""
    exact = lambda s, p, t: (s.x + t * s.dx, s.dx)
    slow = second_order("slow", {}, ("x",), lambda s, p, t: (0.0 * s.x,), exact=exact)
    event = Event(lambda s, p, t: t - 1.0, then=lambda s, p, t: (SPRING, (1.0, 0.0)))
    with pytest.raises(AccuracyError, match="'slow' is not accurate here") as refused:
        run(slow, 1e9, START, events=(event,)).by_name("exact")
    assert refused.value.reached.error > 1e-9
    assert refused.value.reached.t_end == 1e9
    assert run(slow, 10.0, START, events=(event,)).by_name("exact").t_end == 10.0


# -- refusals


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (3e-5, "is about 3e-05, and rtol = 1e-09 was requested; ask for rtol = 0.0001. The motion"),
        (0.049, r"about 0.05, .* ask for rtol = 0.1"),
        (0.05, "large: no digit is certain"),
        (0.2, "is large: no digit is certain, .*; the motion forgets its start; take a shorter"),
        (math.inf, r"large: no digit is certain.*shorter time"),
        (math.nan, r"large: no digit is certain.*shorter time"),
    ],
)
def test_a_refusal_says_what_can_be_had(error, words):
    model = SimpleNamespace(name="any")
    motion = SimpleNamespace(error=error, t_end=3.25, method=METHODS["dop853"])
    text = Run(SimpleNamespace(model=model), 0.0, 3.25, START, 1e-9).refusal(motion)
    assert text.startswith("any, at t = 3.25: the error by method 'dop853' ")
    assert re.search(words, text)


@pytest.mark.parametrize("ulps", [1, 2, 3, 11])
def test_a_motion_of_a_few_roundings_of_time_ends(ulps):
    """This once hung: a step shorter than a rounding of the time does not change the time."""
    begin, end = 3.0 - ulps * 2.0**-51, 3.0 + ulps * 2.0**-51
    try:
        motion = integrate(DRIFT, (begin, end), (0.0, 1.0), 0.5, "dop853")
    except AccuracyError as refused:
        motion = refused.reached
    assert motion.end["x"] == pytest.approx(end - begin, rel=0.5)


# -- across kinks


@pytest.mark.parametrize(("k", "periods"), [(4.0, 1), (9.0, 2), (2.0, 4)])
def test_a_spring_of_two_stiffnesses_is_known_to_be_back_after_its_periods(k, periods):
    """Known to 1e-12, where the difference from a coarser run is a hundred times the error."""
    model = second_order(
        "two", {"k": k}, ("x",), lambda s, p, t: (-where(s.x > 0, p.k, 1.0) * s.x,)
    )
    motion = integrate(model, periods * math.pi * (1 + k**-0.5), (1.0, 0.0), rtol=1e-12)
    assert abs(motion.end["x"] - 1) < motion.error <= 1e-12
    assert abs(motion.end["dx"]) / k**0.5 < motion.error


def test_what_the_first_run_passed_over_counts_by_the_size_that_the_next_one_finds():
    """The dose was 1e-120 before: relative to that, 2000 steps were not enough."""
    light = lambda s, p, t: (1.89, 4.8 * exp(-((s.x - 2860.5) ** 2) / 5.2))
    model = Model("light on the way", {}, ("x", "dose"), light)
    motion = integrate(model, 1530.0, (0.0, 0.0), 1e-9, "dop853")
    assert motion.end["dose"] == pytest.approx(4.8 / 1.89 * math.sqrt(5.2 * math.pi), rel=1e-9)
    assert motion.cost.calls < 20_000
