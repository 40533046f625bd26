"""Segments between events, the scales that judge states, and the distance between two runs."""

import math

import pytest

from newton_euler import Model, exp, integrate, where
from newton_euler.motion import ModelError, second_order
from newton_euler.motion.events import Event
from newton_euler.motion.methods.base import SMALLEST_SCALE, StepError
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.run import Run
from newton_euler.motion.sizes import NATURAL_PART, ROUND_OFF
from newton_euler.motion.solution import AccuracyError, MotionError
from newton_euler.motion.trajectory import (
    INNER_PART,
    KINKED_PART,
    LONGEST_PARTS,
    OWN_PART,
    Trajectory,
)
from tests.models import DRIFT, FALL, needs_heyoka

DOP853 = METHODS["dop853"]


def spring(w=3.0, extra=0.0):
    rates = lambda s, p, t: (-p.w * p.w * s.x + p.extra,)
    return second_order("spring", {"w": w, "extra": extra}, ("x",), rates)


def run(model=None, state=(1.0, 0.0), t1=10.0, t0=0.0, **options):
    return Run(prepared_model(model or spring()), t0, t1, state, 1e-9, **options)


def trajectory(one, *more, tolerance=1e-9, method=DOP853):
    return Trajectory(one, method, tolerance, *more)


# -- events


NOTHING = lambda s, p, t: None


@pytest.mark.parametrize(
    ("options", "ends"),
    [({}, False), ({"terminal": True}, True), ({"then": NOTHING}, True), ({"terminal": True, "then": NOTHING}, True)],
)  # fmt: skip
def test_either_a_terminal_event_or_one_with_then_ends_the_segment(options, ends):
    event = Event(lambda s, p, t: s.x - 3.0, name="there", **options)
    assert event.ends is ends
    motion = integrate(DRIFT, 5.0, (0.0, 1.0), events=event)
    assert [e.name for e in motion.events] == ["there"]
    assert motion.t_end == (pytest.approx(3.0) if ends else 5.0)
    assert motion.ended == ("there at t = 3" if ends else "reached t = 5")


def test_after_an_event_the_motion_goes_on_with_what_then_returns_and_its_events():
    then = lambda s, p, t: (DRIFT, (s.x, -2 * s.v))
    back = Event(lambda s, p, t: s.x - 3.0, then=then, name="wall")
    motion = integrate(DRIFT, 4.0, (0.0, 1.0), events=back)
    assert motion.end == pytest.approx({"x": 1.0, "v": -2.0})
    ends = [t for part in motion.segments for t in (part.t0, part.t1)]
    assert ends == [0.0, pytest.approx(3.0), pytest.approx(3.0), 4.0]
    assert motion.ended == "reached t = 4"
    never = Event(lambda s, p, t: s.x - 3.5, name="never")
    later = Event(lambda s, p, t: s.x - 4.0, terminal=True, name="later")
    first = Event(lambda s, p, t: s.x - 3.0, then=lambda s, p, t: (DRIFT, (s.x, s.v), [later]))
    motion = integrate(DRIFT, 9.0, (0.0, 1.0), events=(first, never))
    assert [e.name for e in motion.events] == ["event 1", "later"]
    assert motion.t_end == pytest.approx(4.0)
    wall = Event(lambda s, p, t: abs(s.x) - 1.0, 1, then=lambda s, p, t: (DRIFT, (s.x, -s.v)))
    motion = integrate(DRIFT, 6.0, (0.0, 1.0), events=wall)
    assert [e.t for e in motion.events] == pytest.approx([1.0, 3.0, 5.0])


def test_an_event_that_changes_the_rates_is_no_longer_looked_for_and_others_are():
    stop = Model("stop", {}, ("x", "v"), lambda s, p, t: (s.v, -1.0 + 0 * s.v))
    brake = Event(lambda s, p, t: s.x - 3.0, then=lambda s, p, t: (stop, (s.x, s.v)), name="brake")
    rest = Event(lambda s, p, t: s.v, terminal=True, name="rest")
    passing = Event(lambda s, p, t: s.x - 3.25, name="passing")
    back = Event(lambda s, p, t: s.x - 2.5, -1, terminal=True, name="back")
    motion = integrate(DRIFT, 9.0, (0.0, 1.0), events=(brake, rest))
    assert [e.name for e in motion.events] == ["brake", "rest"]
    assert motion.end == pytest.approx({"x": 3.5, "v": 0.0}, abs=1e-9)
    # the motion comes back across the position of the brake, without an event there
    motion = integrate(DRIFT, 9.0, (0.0, 1.0), events=(brake, passing, back))
    assert [e.name for e in motion.events] == ["brake", "passing", "passing", "back"]


@pytest.mark.parametrize("given", [5, (DRIFT,), (DRIFT, (1.0, 1.0), (), ())])
def test_what_then_returns_is_a_model_and_a_start(given):
    event = Event(lambda s, p, t: s.x - 3.0, then=lambda s, p, t: given, name="wrong")
    with pytest.raises(ModelError, match=r"then= of 'wrong' returns \(model, start\) or"):
        integrate(DRIFT, 9.0, (0.0, 1.0), events=event)


def test_an_event_at_the_very_end_begins_no_segment_and_one_without_a_name_has_a_number():
    event = Event(lambda s, p, t: t - 3.0, then=lambda s, p, t: (DRIFT, (0.0, 1.0)), name="bell")
    motion = integrate(DRIFT, 3.0, (0.0, 1.0), events=event)
    assert len(motion.segments) == 1
    assert motion.end["x"] == pytest.approx(3.0)
    assert motion.ended == "bell at t = 3"
    events = (Event(lambda s, p, t: s.x - 3.0), Event(lambda s, p, t: s.x - 2.0))
    motion = integrate(DRIFT, 5.0, (0.0, 1.0), events=events)
    assert [e.name for e in motion.events] == ["event 2", "event 1"]
    assert [e.state["x"] for e in motion.events] == pytest.approx([2.0, 3.0])


ZENO = Model("zeno", {}, ("x", "v", "n"), lambda s, p, t: (s.v, 0.0 * s.v, 0.0 * s.n))


def shrunk(part):
    """An event that multiplies the distance to the next event by ``part``."""
    then = lambda s, p, t: (ZENO, (0.0, s.v, s.n * part))
    return Event(lambda s, p, t: s.x - s.n, then=then, name="next")


def test_events_that_accumulate_end_the_motion_and_two_at_once_do_not():
    """Each distance is half of the one before: the events accumulate at t = 2."""
    motion = integrate(ZENO, 3.0, (0.0, 1.0, 1.0), events=shrunk(0.5))
    assert motion.ended.startswith(
        "events follow each other without end: next at t = 2; give then="
    )
    # the motion ends at a segment of 1e-9 of the whole time: 2^-n < 3e-9
    assert len(motion.segments) == 30
    assert motion.t_end == pytest.approx(2.0, abs=1e-8)
    # the first segment may be arbitrarily short
    tap = Event(lambda s, p, t: s.x - 1e-12, then=lambda s, p, t: (DRIFT, (s.x, s.v)), name="tap")
    assert integrate(DRIFT, 3.0, (0.0, 1.0), events=tap).ended == "reached t = 3"


@pytest.mark.parametrize("t0", [0.0, -4.0, 100.0])
def test_progress_is_reported_as_a_fraction_of_the_time(t0):
    parts = []
    one = run(spring(30.0), t0=t0, t1=t0 + 10.0, progress=parts.append)
    trajectory(one)
    assert len(parts) > 3
    assert parts == sorted(parts)
    assert 0.0 < parts[0] < 0.5
    assert parts[-1] == 1.0


def test_a_step_that_cannot_be_taken_is_reported_with_its_place():
    found = trajectory(run(FALL, (1.0,), 1.0))
    assert isinstance(found.failed, StepError)
    assert "fall could not be followed beyond t = 0.5, at x = " in found.ended
    assert found.ended.endswith("may be singular there, or the motion leaves the model")
    model = Model("none", {}, ("x",), lambda s, p, t: (1 / (s.x - s.x),))
    with pytest.raises(MotionError, match="beyond t = 0, at x = 1") as refused:
        integrate(model, 1.0, (1.0,), method="dop853")
    assert refused.value.reached.t_end == 0.0
    assert refused.value.reached.end == {"x": 1.0}


def test_after_an_event_to_a_model_without_its_solution_the_exact_method_gives_way():
    exact = lambda s, p, t: (s.x + s.v * t, s.v)
    free = Model("free", {}, ("x", "v"), lambda s, p, t: (s.v, 0.0 * s.v), exact=exact)
    event = Event(lambda s, p, t: s.x - 3.0, then=lambda s, p, t: (spring(), (s.x, s.v)))
    found = trajectory(run(free, (0.0, 1.0), 5.0, events=(event,)), method=METHODS["exact"])
    steppers = [METHODS["exact"].stepper, DOP853.stepper]
    assert [type(part.stepper) for part in found.segments] == steppers


# -- scales


def test_a_state_is_judged_by_at_least_a_fraction_of_its_natural_size():
    """A spring at rest at its end has zero velocity, but the velocity of the motion is w."""
    w = 300.0
    found = trajectory(run(spring(w)))
    stepper = found.segments[0].stepper
    assert stepper.floors == pytest.approx((SMALLEST_SCALE, NATURAL_PART * w), rel=1e-2)
    assert stepper.noise == pytest.approx((0.0, ROUND_OFF * w), rel=1e-2, abs=0.0)
    assert stepper.stops == ()


def test_later_runs_know_the_sizes_of_the_first():
    w = 300.0
    first = trajectory(run(spring(w), (1.0, 0.0)))
    largest, natural, noise = first.sizes()
    assert largest == pytest.approx((1.0, w), rel=1e-2)
    assert natural == pytest.approx((1.0, w), rel=1e-2)
    assert noise == natural
    later = trajectory(run(spring(w), (1.0, 0.0)), (largest, (0.0, 0.0), natural))
    assert later.segments[0].stepper.floors == pytest.approx((OWN_PART, OWN_PART * w), rel=1e-2)
    assert later.longest_part == LONGEST_PARTS[1]
    assert first.longest_part == LONGEST_PARTS[0]


def test_with_kinks_a_larger_fraction_of_its_size_does_not_count():
    rough = second_order("rough", {}, ("x",), lambda s, p, t: (-s.x - where(s.dx > 0, 0.1, -0.1),))
    known = (2.0, 3.0), (0.0, 0.0), (0.0, 0.0)
    found = trajectory(run(rough), known)
    assert found.segments[0].stepper.floors == pytest.approx((2 * KINKED_PART, 3 * KINKED_PART))


def test_of_what_nothing_is_known_the_smallest_scale_and_no_natural_size_count():
    still = Model("still", {}, ("x", "y"), lambda s, p, t: (0.0 * s.x, 0.0 * s.y))
    found = trajectory(run(still, (0.0, 0.0)))
    assert found.segments[0].stepper.floors == (SMALLEST_SCALE, SMALLEST_SCALE)
    # that scale is not a size of the motion
    assert found.sizes()[0] == (0.0, 0.0)
    model = Model("none", {}, ("x",), lambda s, p, t: (1 / (s.x - s.x),))
    assert trajectory(run(model, (2.0,), 1.0)).sizes() == ((2.0,), (0.0,), (0.0,))


def test_the_natural_sizes_of_the_start_count_unless_a_state_was_nearly_zero():
    w = 300.0
    found = trajectory(run(spring(w)))
    largest = found.sizes()[0]
    times = lambda part: tuple([part * s for s in largest])
    found.natural = times(50.0), times(60.0)
    assert found.sizes() == (largest, times(50.0), times(60.0))
    found.natural = times(200.0), times(60.0)
    assert found.sizes()[1] == pytest.approx((1.0, w), rel=1e-2)


@pytest.mark.parametrize("t1", [0.01, 100.0])
def test_the_natural_size_of_a_position_is_how_far_its_velocity_carries_it(t1):
    assert trajectory(run(DRIFT, (0.0, 1.0), t1=t1)).sizes()[1] == pytest.approx((t1, 0.0))


def test_a_state_that_was_nearly_zero_at_the_start_is_judged_by_the_motion():
    """Its rate at the start means nothing: the state that drives it starts at zero."""
    rates = lambda s, p, t: (s.v, -s.x, 5.0 * s.x, 0.0)
    model = Model("driven", {}, ("x", "v", "y", "z"), rates)
    found = trajectory(run(model, (0.0, 1.0, 0.0, 0.0), 7.0))
    assert found.natural[0][2] == 0.0
    largest, natural, _ = found.sizes()
    assert natural[2] == pytest.approx(5.0, rel=0.1)
    assert largest[:2] == pytest.approx((1.0, 1.0), rel=0.1)


@needs_heyoka
def test_series_have_units_only_if_they_are_scaled():
    taylor = METHODS["taylor"]
    known = (4.0, 1e6), (8.0, 1e3), (0.0, 0.0)
    plain = trajectory(run(), known, method=taylor)
    assert plain.segments[0].stepper.floors == (0.0, 0.0)
    assert plain.units == ()
    scaled = trajectory(run(state=(16.0, 0.0)), known, True, method=taylor)
    assert scaled.units == (16.0, 1e6)
    assert scaled.segments[0].stepper.units


def test_a_fixed_step_does_not_stop_at_pulses():
    model = second_order("struck", {}, ("x",), lambda s, p, t: (exp(-(((t - 5.0) / 0.01) ** 2)),))
    assert len(trajectory(run(model)).segments[0].stepper.stops) == 2
    assert trajectory(run(model, step=0.1)).segments[0].stepper.stops == ()


@pytest.mark.parametrize(
    ("options", "own", "found"),
    [({}, None, 7), ({}, 5, 5), ({"progress": print}, None, None), ({"events": (Event(lambda s, p, t: s.x),)}, None, None)],
)  # fmt: skip
def test_samples_are_those_of_the_run_unless_there_are_events(options, own, found):
    assert trajectory(run(t1=1.0, samples=7, **options), None, False, own).samples == found


# -- the distance between two runs


def test_the_distance_is_the_largest_over_the_scales():
    a, b = (trajectory(run(state=(x, 0.0), t1=1e-3)) for x in (1.0, 1.0 + 1e-5))
    assert a.difference(a) == 0.0
    assert a.difference(b) == pytest.approx(1e-5, rel=1e-3)
    assert b.difference(a) == a.difference(b)
    a, b = (trajectory(run(DRIFT, (1.0, v), 1e-3)) for v in (1e-3, 1.001e-3))
    assert a.difference(b) == pytest.approx(1e-3, rel=1e-2)
    assert b.difference(a) == a.difference(b)


@pytest.mark.parametrize("t0", [0.0, -4.0, 100.0])
def test_of_two_ends_the_time_between_counts_too(t0):
    event = lambda place: (Event(lambda s, p, t: s.x - place, terminal=True),)
    slow = [
        trajectory(run(DRIFT, (1e6, 1.0), t0 + 10.0, t0, events=event(1e6 + x))) for x in (5.0, 5.5)
    ]
    assert slow[0].difference(slow[1]) == pytest.approx(0.05)


def test_two_runs_with_other_events_are_as_far_apart_as_can_be():
    event = (Event(lambda s, p, t: s.x - 3.0, then=lambda s, p, t: (DRIFT, (s.x, s.v))),)
    a = trajectory(run(DRIFT, (0.0, 1.0), 5.0, events=event))
    b = trajectory(run(DRIFT, (0.0, 1.0), 5.0))
    assert a.difference(b) == b.difference(a) == 1.0
    other = Model("other", {}, ("y", "u"), lambda s, p, t: (s.u, 0.0 * s.u))
    assert b.difference(trajectory(run(other, (0.0, 1.0), 5.0))) == 1.0


def test_runs_that_end_at_one_place_by_chance_differ_on_the_way():
    """After one turn all amplitudes end at their starts, but on the way they differ."""
    t = 2 * math.pi / 3.0
    tight = trajectory(run(t1=t), tolerance=1e-12)
    other = trajectory(run(spring(6.0), (1.0, 0.0), t), tolerance=1e-12)
    end = max(abs(u - v) for u, v in zip(tight.segments[0].x1, other.segments[0].x1, strict=True))
    assert end < 1e-9
    assert 0.1 * INNER_PART < tight.difference(other) < 3 * INNER_PART


def test_accumulating_events_are_compared_by_their_end_only():
    start = 0.0, 1.0, 1.0
    a, b = (trajectory(run(ZENO, start, 4.0, events=(shrunk(part),))) for part in (0.5, 0.6))
    assert len(a.segments) != len(b.segments)
    assert a.difference(b) == pytest.approx(0.5 / 4.0, rel=1e-3)  # they end at 2 and at 2.5
    called_so = Event(
        lambda s, p, t: s.x - 1.0, 0, True, name="events follow each other without end"
    )
    a, b = (trajectory(run(ZENO, (0.0, 1.0, n), 4.0, events=(called_so,))) for n in (2.0, 5.0))
    assert a.difference(b) > 0.5  # of n


def test_a_state_next_to_zero_sets_no_scale_for_its_error():
    """The square of such a state underflows: once, no step was small enough at the start."""
    model = Model("two decays", {}, ("x", "y"), lambda s, p, t: (-s.x, -s.y))
    motion = integrate(model, 1.0, (1.0, 2e-317), 1e-9, "dop853")
    assert motion.end["y"] == pytest.approx(2e-317 / math.e, rel=1e-3)


def test_steps_that_are_repeated_are_none_of_those_before_the_last_search():
    """At the top of a throw lies a layer, so thin that round-off in it is large."""
    p = {"g": 7.691800999360371, "w": 3.719184142370538e-07, "c": 19.563782473654317}
    rates = lambda s, p, t: (s.v, -p.g, 10.0 * exp(-(((s.y - p.c) / p.w) ** 2)))
    start = 0.0, 17.348240384324477, 0.0
    with pytest.raises(AccuracyError, match="ask for rtol"):
        integrate(Model("throw", p, ("y", "v", "dose"), rates), 4.2852976478405385, start, 1e-12)
