"""The record of a motion: its samples, its states at any time, its drift, and what it says."""

import math
import pickle
from dataclasses import replace

import numpy as np
import pytest

from newton_euler import Model, integrate, sin
from newton_euler.motion import Event, ModelError
from newton_euler.motion.solution import AccuracyError, Cost, MotionError
from tests.models import DRIFT, oscillator

OTHER = Model("other", {}, ("x", "u"), lambda s, p, t: (s.u, 0.0 * s.u))


def drift(t=5.0, **options):
    return integrate(DRIFT, t, (0.0, 1.0), 1e-9, "dop853", **options)


def leap(**options):
    """At x = 3 the state is set to 10 and goes on twice as fast, in another model."""
    event = Event(lambda s, p, t: s.x - 3.0, then=lambda s, p, t: (OTHER, (10.0, 2 * s.v)))
    return drift(events=event, **options)


# -- times and states


def test_the_times_are_those_of_the_steps_before_the_ends_of_their_segments():
    motion = drift()
    assert motion.times.tolist() == motion.segments[0].stepper.step_times
    assert len(motion.times) > 2
    motion = leap()
    there, times = motion.events[0].t, motion.times.tolist()
    assert there == pytest.approx(3.0)
    first, second = (part.stepper.step_times for part in motion.segments)
    assert times == [t for t in first if t < there] + second
    assert (times[0], times[-1]) == (0.0, 5.0)
    motion = integrate(oscillator().changed(k=1.0), (1.0, 3.0), (1.0, 0.0))
    assert motion.times == pytest.approx(np.linspace(1.0, 3.0, 101))
    assert motion.states["x"] == pytest.approx(np.cos(motion.times - 1.0))


def test_samples_are_those_that_the_motion_reached_the_last_to_the_last_digit():
    stop = Event(lambda s, p, t: s.x - 3.0, terminal=True)
    assert drift(samples=[1.0, 2.0, 4.0], events=stop).times.tolist() == [1.0, 2.0]
    assert drift(samples=4, events=stop).times == pytest.approx([0.0, 1.0, 2.0, 3.0])
    for motion in (leap(), integrate(oscillator(exact=False), 7.3, (1, 0.3))):
        for name, x in motion.end.items():
            assert motion.states[name][-1] == x


def test_states_are_those_of_their_segment_and_where_two_meet_of_the_later_one():
    motion = leap()
    times = [0.0, 2.9, motion.events[0].t, 4.0, 5.0]
    found = motion.at(times)
    assert list(found) == ["x", "v", "u"]
    assert found["x"] == pytest.approx([0.0, 2.9, 10.0, 12.0, 14.0])
    assert found["v"] == pytest.approx([1.0, 1.0, math.nan, math.nan, math.nan], nan_ok=True)
    assert found["u"] == pytest.approx([math.nan, math.nan, 2.0, 2.0, 2.0], nan_ok=True)
    assert motion.end == {"x": pytest.approx(14.0), "u": 2.0}
    assert motion.at(5.0)["x"] == motion.end["x"]


def test_a_time_gives_numbers_and_an_array_of_times_arrays():
    motion = drift()
    assert motion.at(2.0) == {"x": pytest.approx(2.0), "v": 1.0}
    assert {type(x) for x in motion.at(2).values()} == {float}
    assert motion.at([1.0, 2.0])["x"].tolist() == pytest.approx([1.0, 2.0])
    with pytest.raises(ModelError, match=r"of one axis; got an array of shape \(1, 2\)"):
        motion.at([[1.0, 2.0]])


@pytest.mark.parametrize("t", [0.99, 5.01, math.nan, [2.0, 6.0]])
def test_there_is_no_state_outside_the_motion(t):
    motion = integrate(DRIFT, (1.0, 5.0), (0.0, 1.0))
    assert motion.at([1.0, 5.0])["x"] == pytest.approx([0.0, 4.0])
    with pytest.raises(ModelError, match="the motion goes from t = 1 to 5; got t = "):
        motion.at(t)


# -- drift


def drift_of(invariant, start=-1.0, **options):
    model = Model("grows", {}, ("x",), lambda s, p, t: (1.0,), {"it": invariant})
    return integrate(model, 4.0, (start,), 1e-9, "dop853", **options).drift


def test_the_drift_is_the_largest_change_over_the_largest_value_from_the_start():
    assert drift_of(lambda s, p, t: s.x) == {"it": pytest.approx(4.0 / 3.0)}
    assert drift_of(lambda s, p, t: -s.x) == {"it": pytest.approx(4.0 / 3.0)}
    # neither over the last value nor over the change itself
    assert drift_of(lambda s, p, t: 10 + s.x * (2 - s.x), samples=5)["it"] == pytest.approx(4 / 11)
    assert drift_of(lambda s, p, t: float(max(s.x, -9.0))) == {"it": pytest.approx(4.0 / 3.0)}
    assert drift_of(lambda s, p, t: 5.0) == {"it": 0.0}
    assert drift_of(lambda s, p, t: 0 * s.x) == {"it": 0.0}
    assert drift_of(lambda s, p, t: s.x, samples=[3.0])["it"] == pytest.approx(3.0 / 2.0)


@pytest.mark.parametrize("places", [(10.0, 1000.0), (1000.0, 10.0)])
def test_each_segment_is_compared_with_its_own_start(places):
    model = Model("grows", {}, ("x",), lambda s, p, t: (1.0,), {"it": lambda s, p, t: s.x})
    first, second = places
    event = Event(lambda s, p, t: t - 2.0, then=lambda s, p, t: (model, (second,)))
    motion = integrate(model, 4.0, (first,), 1e-9, "dop853", event, samples=5)
    assert motion.drift == {"it": pytest.approx(2.0 / 12.0)}


# -- what it says


def test_the_record_reads_in_words():
    motion = replace(drift(t=(1.0, 4.0)), cost=Cost(0.5, 0.25, 7), estimate=2e-10, rtol=1e-9)
    assert motion.explain().splitlines() == [
        "drift, from t = 1 to 4: reached t = 4",
        "method: dop853 (Runge-Kutta of order 8 in straight-line Python)",
        "error of the last state: about 2e-10, asked for 1e-09",
        "cost: 500 ms, 7 calls of the right-hand side, 250 ms to prepare",
    ]
    assert str(motion) == motion.explain()
    assert "not reached" not in str(replace(motion, estimate=1e-9))
    assert "asked for 1e-09, not reached" in str(replace(motion, estimate=1.1e-9))


@pytest.mark.parametrize("count", [9, 10, 11, 13])
def test_ten_events_are_listed_and_more_are_counted(count):
    event = Event(lambda s, p, t: sin(math.pi * s.x), name="tick")
    lines = str(drift(t=count + 0.5, events=event)).splitlines()
    ticks = [f"tick at t = {n}" for n in range(1, min(count, 10) + 1)]
    more = [f"... and {count - 10} more events"] if count > 10 else []
    assert lines[3:-1] == ticks + more


def test_an_error_that_is_computed_on_demand_is_computed_once():
    asked = []
    motion = replace(drift(), estimate=lambda: asked.append(1) or 3e-10)
    assert (motion.error, motion.error) == (3e-10, 3e-10)
    assert asked == [1]


@pytest.mark.parametrize("kind", [MotionError, AccuracyError])
def test_the_error_of_a_motion_that_failed_is_sent_with_what_was_reached(kind):
    error = kind("too far", drift())
    again = pickle.loads(pickle.dumps(error))
    assert (type(again), str(again)) == (kind, "too far")
    assert again.reached.end == error.reached.end
    assert again.reached.at(1.3) == error.reached.at(1.3)
