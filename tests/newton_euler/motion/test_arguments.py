"""The arguments of an integration: what is accepted and how it is used, and what is refused."""

import math
from fractions import Fraction

import numpy as np
import pytest

from newton_euler.motion import ModelError, arguments, second_order
from newton_euler.motion.events import Event

SPRING = second_order("spring", {"k": 4.0, "c": 0}, ("x",), lambda s, p, t: (-p.k * s.x - p.c,))


@pytest.mark.parametrize(
    ("t", "found"),
    [(2.0, (0.0, 2.0)), (3, (0.0, 3.0)), ((1, 2.5), (1.0, 2.5)), ([-2.0, -1.0], (-2.0, -1.0))],
)
def test_the_time_is_an_end_or_a_pair(t, found):
    assert arguments.time_span(t) == found
    assert all(type(x) is float for x in arguments.time_span(t))


@pytest.mark.parametrize(("given", "words"), [
    (["x", "12", b"12", True, None, (1.0,), (1.0, 2.0, 3.0), (1.0, None), np.ones((2, 2))], r"time at which to end, or \(from, to\)"),
    ([0.0, -1.0, 0, math.inf, math.nan, (1.0, 1.0), (2.0, 1.0), (0.0, math.inf), (-math.inf, 1.0), (math.nan, 1)],
     "time runs forward"),
], ids=["no time", "not forward, or not finite"])  # fmt: skip
def test_anything_else_is_refused_as_a_time(given, words):
    for t in given:
        with pytest.raises(ModelError, match=words):
            arguments.time_span(t)


@pytest.mark.parametrize(
    ("method", "rtol"),
    [("auto", 1e-15), ("taylor", 1e-15), ("dop853", 1e-13), ("verlet", 1e-7), ("auto", 0.999)],
)
def test_an_rtol_that_a_method_reaches_is_taken_and_less_refused(method, rtol):
    arguments.check_options(rtol, method)
    if rtol < 0.5:
        with pytest.raises(ModelError, match=f"cannot reach it, the least is {rtol:g}"):
            arguments.check_options(0.99 * rtol, method)


@pytest.mark.parametrize(
    ("option", "bad", "words"),
    [
        ("rtol", [0.0, -1e-9, 1.0, 2, math.nan, "1e-9", None, True], "a number between 0 and 1"),
        ("step", [0.0, -0.1, math.nan, math.inf, True, "0.1"], "the step is a positive time"),
        ("method", ["euler", ["verlet"], 3], "method is 'auto' or one of exact, taylor"),
        ("progress", [0.5], "progress is a function of the fraction"),
    ],
)
def test_options_with_which_no_model_can_be_integrated(option, bad, words):
    usual = {"rtol": 1e-6, "method": "auto", "step": None, "progress": print}
    arguments.check_options(**usual)
    for x in bad:
        with pytest.raises(ModelError, match=words):
            arguments.check_options(**usual | {option: x})


def test_a_tolerance_may_be_any_real_number_and_does_not_matter_with_a_fixed_step():
    for x in (np.float32(1e-3), Fraction(1, 1000), np.float64(1e-3)):
        assert type(arguments.check_options(x, "auto")) is float
    arguments.check_options(0.0, "verlet", step=0.1)


@pytest.mark.parametrize("nothing", [np.array(1.0), np.array(1j)], ids=str)
def test_an_array_without_an_axis_has_no_entries(nothing):
    with pytest.raises(ModelError, match="a value for each of"):
        arguments.start_state(SPRING, nothing)
    with pytest.raises(ModelError, match="events are an Event, or several"):
        arguments.event_tuple(nothing)


def test_events_are_one_or_several():
    event = Event(lambda s, p, t: s.x)
    for given in (event, [event], (event,), iter([event])):
        assert arguments.event_tuple(given) == (event,)
    assert arguments.event_tuple(()) == ()
    for bad in ((3,), [lambda s, p, t: s.x]):
        with pytest.raises(ModelError, match=r"events are made by Event"):
            arguments.event_tuple(bad)
    for bad in (3, "x", range(3)):
        with pytest.raises(ModelError, match=r"events are an Event, or several, got"):
            arguments.event_tuple(bad)


@pytest.mark.parametrize("samples", [None, 1, 7])
def test_a_number_of_samples_stays_as_it_is(samples):
    assert arguments.sample_request(samples, 2.0, 5.0) is samples


@pytest.mark.parametrize("whole", [np.int64(7), np.array(7), np.uint8(7)], ids=repr)
def test_a_number_of_samples_may_be_one_of_numpy(whole):
    assert arguments.sample_request(whole, 2.0, 5.0) == 7
    with pytest.raises(ModelError, match="samples are a number of times"):
        arguments.sample_request(0 * whole, 2.0, 5.0)


@pytest.mark.parametrize("samples", [[2.0, 3.5, 5.0], (2, 5), (t for t in (2.0, 5.0)), [5.0]])
def test_samples_are_times_of_the_motion_its_ends_among_them(samples):
    found = arguments.sample_request(samples, 2.0, 5.0)
    assert found.dtype == float
    assert {found[0], found[-1]} <= {2.0, 5.0}


@pytest.mark.parametrize(
    "samples", [0, -1, 10**400, 2.5, True, "4", b"4", [], [[3.0, 4.0]], ["x"]], ids=str
)
def test_anything_else_is_refused_as_samples(samples):
    with pytest.raises(ModelError, match="samples are a number of times, or times; got"):
        arguments.sample_request(samples, 2.0, 5.0)


@pytest.mark.parametrize("t", [1.99, 5.01, math.nan])
def test_samples_outside_the_motion_are_refused(t):
    with pytest.raises(ModelError, match=f"from t = 2 to 5, .*; got {t:g} among them"):
        arguments.sample_request([3.0, t, 4.0], 2.0, 5.0)


STARTS = [
    (1.0, 2.0), [1.0, 2.0], (1, 2), np.array([1.0, 2.0]), np.array([1, 2]), (np.float64(1.0), 2), {"dx": 2, "x": 1.0},
    iter([1.0, 2.0]),
]  # fmt: skip


@pytest.mark.parametrize("start", STARTS, ids=lambda start: type(start).__name__)
def test_a_start_is_a_tuple_of_floats_in_the_order_of_the_states(start):
    found = arguments.start_state(SPRING, start)
    assert found == (1.0, 2.0)
    assert [type(x) for x in found] == [float, float]


def test_arrays_in_a_start_are_many_values_of_a_state():
    many = np.array([1.0, 2.0])
    x, v = arguments.start_state(SPRING, (many, 3))
    assert x is many
    assert v == 3.0
    x, v = arguments.start_state(SPRING, np.array([[1.0, 2.0], [3.0, 4.0]]))
    assert x.tolist() == [1.0, 2.0]
    assert v.tolist() == [3.0, 4.0]


@pytest.mark.parametrize(
    ("start", "words"),
    [
        (3.0, "the start of 'spring' is a value for each of x, dx, not 3.0"),
        ({"x": 1.0, "y": 2.0}, "spring has no state 'y'; its states are x, dx"),
        ((1.0, "2"), "needs a number for dx, got '2'"),
        ((True, 2.0), "needs a number for x, got True"),
        ((1.0, None), "needs a number for dx, got None"),
        ((1.0, math.nan), "has dx = nan; a motion needs finite numbers"),
        ((math.inf, 1.0), "has x = inf; a motion needs finite numbers"),
        ((-math.inf, 1.0), "has x = -inf; a motion needs finite numbers"),
        ((math.inf, -math.inf), "has x = inf"),
        ((1.0, 2.0, 3.0), "spring has the 2 states x, dx; got 3 values"),
        ((1.0, np.array(["a", "b"])), "needs a number for dx; got array"),
    ],
)
def test_a_start_that_does_not_fit_is_refused_in_words(start, words):
    with pytest.raises(ModelError) as refused:
        arguments.start_state(SPRING, start)
    assert words in str(refused.value)
