"""Which zeros of a function are events, along a motion whose states are all known."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from newton_euler import cos, exp, sqrt, where
from newton_euler.motion import Event, Model, ModelError, integrate
from newton_euler.motion.events import EventLocator, events_in_step
from newton_euler.motion.zeros import EPS
from tests.models import TAYLOR, oscillator


def times(function, t=20.0, start=(1.0, 0.0), closed=True, **options):
    spring = oscillator(closed).changed(k=1.0)
    return [e.t for e in integrate(spring, t, start, events=Event(function, **options)).events]


PASSAGES = math.pi * (np.arange(6) + 0.5)  # of x = cos(t) through zero, to t = 20
EVERY_CHANGE_OF_SIGN = {
    "x": lambda s, p, t: s.x,
    "huge": lambda s, p, t: 1e250 * s.x,
    "tiny": lambda s, p, t: 1e-250 * s.x,
    "decaying": lambda s, p, t: exp(-t) * s.x,
    "kink": lambda s, p, t: s.x + abs(s.x) / 2,
    "flat kink": lambda s, p, t: s.x * abs(s.x),
    "jump": lambda s, p, t: where(s.x > 0, 1.0, -2.0),
    "branch": lambda s, p, t: 1.0 if s.x > 0 else -2.0,
}
NO_CHANGE = {
    "square": lambda s, p, t: s.dx**2,
    "modulus": lambda s, p, t: abs(s.x),
    "touching": lambda s, p, t: 1 - s.x,
    "round-off": lambda s, p, t: s.x**2 + s.dx**2 - 1,
    "zero": lambda s, p, t: 0 * s.x,
    "jump": lambda s, p, t: where(s.x > 0, 1.0, 5.0),
    "pole": lambda s, p, t: 1 / s.x,
}
BOTH = pytest.mark.parametrize("closed", [True, False])


@pytest.mark.one_in(3)
@BOTH
@pytest.mark.parametrize("name", EVERY_CHANGE_OF_SIGN)
def test_every_change_of_sign_is_an_event_of_its_direction(name, closed):
    found = times(EVERY_CHANGE_OF_SIGN[name], closed=closed)
    assert found == pytest.approx(PASSAGES, abs=1e-9)
    for direction, part in ((-1, found[::2]), (1, found[1::2])):
        one_way = times(EVERY_CHANGE_OF_SIGN[name], closed=closed, direction=direction)
        assert one_way == pytest.approx(part, abs=1e-10)


@pytest.mark.parametrize("name", NO_CHANGE)
def test_without_a_passage_through_zero_there_is_no_event(name):
    assert times(NO_CHANGE[name]) == []


@BOTH
@pytest.mark.parametrize("start", [(0.0, 1.0), (0.0, -1.0), (math.sin(math.pi), -1.0)])
def test_a_zero_at_the_start_does_not_count(start, closed):
    assert times(lambda s, p, t: s.x, 4.0, start, closed) == pytest.approx([math.pi], abs=1e-9)


@BOTH
def test_a_zero_at_the_end_counts(closed):
    assert times(lambda s, p, t: t - 3.0, 3.0, closed=closed) == [3.0]
    assert times(lambda s, p, t: t - 3.0, 2.999, closed=closed) == []


@BOTH
def test_a_zero_is_found_before_the_function_loses_its_value(closed):
    found = times(lambda s, p, t: sqrt(s.x) - 0.1, 3.0, closed=closed, terminal=True)
    assert found == pytest.approx([math.acos(0.01)], abs=1e-9)


PARTS = st.tuples(st.floats(0.1, 60.0), st.floats(0.0, 6.3), st.floats(0.2, 1.0))


@settings(max_examples=25)
@given(st.lists(PARTS, min_size=1, max_size=4))
def test_sums_of_oscillations_change_sign_as_often_as_a_fine_grid_shows(parts):
    g = lambda s, p, t: sum(a * (s.x * cos(w * t + f) + s.dx / 3) for w, f, a in parts)
    t = np.linspace(0.0, 10.0, 400_001)
    x = sum(a * (np.cos(t) * np.cos(w * t + f) - np.sin(t) / 3) for w, f, a in parts)
    change = np.flatnonzero(np.sign(x[1:]) * np.sign(x[:-1]) < 0)
    found = times(g, 10.0)
    # a grid cannot judge where the function just touches zero
    turn = np.flatnonzero((np.diff(x)[1:] * np.diff(x)[:-1] < 0) & (abs(x[1:-1]) < 1e-6))
    if not len(turn) and min(abs(x[0]), abs(x[-1])) > 1e-6:
        assert len(found) == len(change)
        assert found == pytest.approx(t[change], abs=3e-5)


class _Steps:
    """A stepper that has taken one step along x = t, from 0 to 10."""

    start, step_times, goal, t, x = (0.0, (0.0,)), [0.0, 10.0], 10.0, 0.0, (0.0,)

    class system:
        @staticmethod
        def function(f):
            return f

    def interpolate(self, n, times):
        return times[None]

    def state_at(self, t):
        return (t,)


def found_in_step(function, n=0, steps=None, at_start=False):
    """The times of one event in a step."""
    locator = EventLocator(Event(function), steps or _Steps(), at_start)
    return [t for t, is_event in locator.search(n) if is_event]


def test_events_come_in_order_and_those_that_end_the_segment_last():
    steps = _Steps()
    events = [
        Event(lambda t, x: x - 5, terminal=True),
        Event(lambda t, x: x - 5),
        Event(lambda t, x: (x - 2) * (x - 7)),
    ]
    locators = [EventLocator(event, steps, False) for event in events]
    found = [pair for pairs in events_in_step(locators, 0) for pair in pairs]
    assert [k for _, k in found] == [2, 1, 0, 2]
    assert [t for t, _ in found] == pytest.approx([2, 5, 5, 7], abs=1e-14)


def test_a_step_without_length_or_after_the_end_has_no_events_and_one_beside_its_end_stays():
    """Close to the goal a step may be shorter than the last digit of the time."""
    steps = _Steps()
    steps.step_times = [0.0, 0.0, 10.0]
    locator = EventLocator(Event(lambda t, x: x * (x - 5)), steps, True)
    assert list(locator.search(0)) == []
    assert [t for t, is_event in locator.search(1) if is_event] == pytest.approx([5.0])
    # after the end the other function has billions of zeros
    wild = lambda t, x: np.where(x < 2, 1.0, np.sin(1e9 * x))
    events = [Event(lambda t, x: x - 1, terminal=True), Event(wild)]
    locators = [EventLocator(event, _Steps(), False) for event in events]
    assert next(events_in_step(locators, 0)) == [(pytest.approx(1.0), 0)]
    # the next step may find the same event, and the states of the two steps differ
    assert found_in_step(lambda t, x: x - 10, steps=_Rough(1e-3)) == [10.0]


class _Found:
    """A locator that has found one event at this time."""

    event = Event(lambda t, x: x)

    def __init__(self, t):
        self.t = t

    def search(self, n):
        yield self.t, True


@pytest.mark.parametrize("t", [0.0, 1.0, -1.0])
def test_events_a_few_round_offs_apart_are_at_one_time(t):
    together = events_in_step([_Found(t), _Found(t + 4 * EPS * abs(t))], 0)
    assert [len(pairs) for pairs in together] == [2]
    if t:
        apart = events_in_step([_Found(t), _Found(t + 6 * EPS)], 0)
        assert [len(pairs) for pairs in apart] == [1, 1]


# -- zeros with the states of a step to there


class _Rough(_Steps):
    """A step whose interpolation is ahead by a given amount."""

    def __init__(self, ahead):
        self.ahead = ahead

    def interpolate(self, n, times):
        return times[None] + self.ahead


@pytest.mark.parametrize("ahead", [1e-6, -1e-6, 1e-3, -1e-3])
def test_an_event_is_where_the_more_accurate_states_have_it(ahead):
    found = found_in_step(lambda t, x: x * x - 25, steps=_Rough(ahead))
    assert found == pytest.approx([5.0], abs=1e-12)


@pytest.mark.parametrize("size", [1, 1e-200])
@pytest.mark.parametrize("ahead", [5e-9, -5e-7, 5e-5, 5e-3, -5e-3])
def test_a_jump_is_where_the_more_accurate_states_have_it(ahead, size):
    found = found_in_step(lambda t, x: size * np.where(x < 5, -1.0, 2.0), steps=_Rough(ahead))
    assert found == pytest.approx([5.0], abs=1e-14)


@pytest.mark.parametrize("ahead", [0.1, -0.1])
@pytest.mark.parametrize("function", [lambda t, x: x - 5, lambda t, x: np.where(x < 5, -1.0, 2.0)])
def test_states_that_are_far_from_the_interpolation_move_no_event(function, ahead):
    """A shift of more than a thousandth of the step is not left to Newton's method."""
    assert found_in_step(function, steps=_Rough(ahead)) == pytest.approx([5.0 - ahead], abs=1e-12)


def test_a_function_that_branches_is_given_an_array_only_once():
    arrays = []

    def branching(t, x):
        if np.ndim(x):
            arrays.append(x)
        return x - 5 if x < 6 else x - 4

    assert found_in_step(branching) == pytest.approx([5.0])
    assert len(arrays) == 1


@BOTH
def test_what_a_function_refuses_on_the_way_is_raised_as_it_is(closed):
    def table(s, p, t):
        if t > 1.0:
            raise ModelError("the table ends at 1 s")
        return s.x + 2.0

    words = r"^the table ends at 1 s\nThis came up in table, where s = "
    with pytest.raises(ModelError, match=words):
        times(table, closed=closed)
    with pytest.raises(ValueError, match=r"(?s)math domain error.*has no value from t = "):
        times(lambda s, p, t: math.sqrt(1.0 - t) + (s.x > 9.0 and 0.0), closed=closed)


def test_direction_and_end_may_be_of_numpy():
    event = Event(lambda s, p, t: s.x, np.int64(-1), np.True_)
    (found,) = integrate(oscillator().changed(k=1.0), 20.0, (1.0, 0.0), events=event).events
    assert found.t == pytest.approx(PASSAGES[0])


@pytest.mark.parametrize("method", ["exact", "dop853", TAYLOR])
def test_a_ball_in_a_corner_bounces_off_both_walls(method):
    """Of two events at one time, each applies its own ``then``."""
    exact = lambda s, p, t: (s.x + s.u * t, s.y + s.v * t, s.u, s.v)
    ball = Model(
        "ball", {}, ("x", "y", "u", "v"), lambda s, p, t: (s.u, s.v, 0.0, 0.0), exact=exact
    )
    walls = (
        Event(lambda s, p, t: s.x, -1, then=lambda s, p, t: (ball, (0.0, s.y, -s.u, s.v))),
        Event(lambda s, p, t: s.y, -1, then=lambda s, p, t: (ball, (s.x, 0.0, s.u, -s.v))),
    )
    motion = integrate(ball, 3.0, (1.0, 1.0, -1.0, -1.0), 1e-9, method, walls)
    assert [e.name for e in motion.events] == ["event 1", "event 2"]
    assert [motion.end[n] for n in "xyuv"] == pytest.approx([2.0, 2.0, 1.0, 1.0], abs=1e-8)
