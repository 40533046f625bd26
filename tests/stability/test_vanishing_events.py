"""Events on a motion without steps: a closed form is one step over the whole time, and every one of
thousands of zeros in it is found; what cannot be found is refused, not left out.
"""

import math

import numpy as np
import pytest
from scipy.special import ellipk

from newton_euler import Frame, sin, sqrt
from newton_euler.motion import Event, ModelError, integrate
from newton_euler.motion.events import EventError
from newton_euler.scenes.planar.pendulum import physical_pendulum
from tests.honesty.models import spring


def test_all_2832_zeros_of_a_pendulum_to_t_3000_are_found():
    """Against the complete elliptic integral: it passes its lowest place every half period."""
    k, a = 10.0, 1.0
    pendulum = physical_pendulum(2.0, 0.5, 0.5, k)
    rate = math.sqrt(2.0 * k * 0.5 / (0.5 + 2.0 * 0.25))
    half = 2 * ellipk(math.sin(a / 2) ** 2) / rate
    motion = integrate(pendulum, 3000.0, (a, 0.0), events=Event(lambda s, p, t: s.theta))
    exact = half * (np.arange(int(3000.0 / half + 0.5)) + 0.5)
    assert motion.method.name == "exact"
    assert len(motion.events) == len(exact) == 2832
    assert np.abs([e.t for e in motion.events] - exact).max() < 1e-9


@pytest.mark.parametrize("line", [0.0, 0.7, -0.999])
def test_all_zeros_of_a_thousand_swings_are_found(line):
    passes = Event(lambda s, p, t: s.x - line)
    motion = integrate(spring(closed=True, k=1.0), 2000 * math.pi, (1.0, 0.0), events=passes)
    turns, a = 2 * math.pi * np.arange(1000)[:, None], math.acos(line)
    exact = (turns + [a, 2 * math.pi - a]).reshape(-1)
    assert len(motion.events) == 2000
    # near the turning point the time is known to the round-off of the position over the speed
    assert [e.t for e in motion.events] == pytest.approx(exact, abs=1e-11)


@pytest.mark.parametrize("closed", [True, False])
def test_all_zeros_of_a_function_much_faster_than_the_motion_are_found(closed):
    motion = integrate(
        spring(closed=closed, k=1.0), 3.0, (1.0, 0.0), events=Event(lambda s, p, t: sin(1e3 * t))
    )
    exact = math.pi / 1e3 * np.arange(1, 955)
    assert [e.t for e in motion.events] == pytest.approx(exact, abs=1e-12)


def test_an_early_end_of_a_long_motion_is_found_without_a_search_of_the_rest():
    """The rest has 3e8 zeros, more than can be looked for."""
    end = Event(lambda s, p, t: s.x, terminal=True)
    motion = integrate(spring(closed=True, k=1.0), 1e9, (1.0, 0.0), events=end)
    assert motion.t_end == pytest.approx(math.pi / 2, abs=1e-14)


def test_more_zeros_than_can_be_looked_for_are_refused_in_words(monkeypatch):
    monkeypatch.setattr("newton_euler.motion.zeros.MAX_PIECES", 2000)
    zero = Event(lambda s, p, t: s.x, name="zero")
    with pytest.raises(EventError, match=r"event 'zero' was sampled in \d+ pieces .* too many"):
        integrate(spring(closed=True, k=1.0), 1e9, (1.0, 0.0), method="exact", events=zero)


@pytest.mark.parametrize("closed", [True, False])
def test_a_function_without_a_value_on_part_of_the_way_is_refused(closed):
    event = Event(lambda s, p, t: sqrt(s.x), name="root")
    with pytest.raises(ModelError, match=r"event 'root' has no value from t = 1\.5707963"):
        integrate(spring(closed=closed, k=1.0), 4.0, (1.0, 0.0), events=event)


@pytest.mark.parametrize(("arguments", "words"), [
    ({"direction": "down"}, "the direction of an event is 1 .* got 'down'"),
    ({"direction": 2}, "the direction of an event is 1 .* got 2"),
    ({"direction": True}, "the direction of an event is 1 .* got True"),
    ({"direction": np.array([1, -1])}, "the direction of an event is 1 .* got array"),
    ({"function": "x"}, r"an event takes a function \(s, p, t\) .* got 'x'"),
    ({"terminal": 1}, "terminal is True for an event that ends the motion, or False, got 1"),
    ({"then": "stop"}, "then= of an event is a function .* got 'stop'"),
    ({"name": 3}, "the name of an event is a text, got 3"),
])  # fmt: skip
def test_an_event_made_wrongly_is_refused(arguments, words):
    with pytest.raises(ModelError, match=words):
        Event(**{"function": lambda s, p, t: s.x, **arguments})


@pytest.mark.parametrize(("function", "words"), [
    (lambda s, p, t: s.x < 0.5, "returns True or False, which has no zeros: return a number"),
    (lambda s, p, t: s.x if s.x > 0.5 else False, "returns True or False"),
    (lambda s, p, t: None, "returns a real number, not None"),
    (lambda s, p, t: "down", "returns a real number, not 'down'"),
    (lambda s, p, t: (s.x, s.dx), "returns a real number, not (1.0, 0.0)"),
    (lambda s, p, t: Frame("F").vector(s.x, 0, 0), "returns a real number, not"),
    (lambda s, p, t: s.y, "fails when it is tried: there is no state 'y'; there are x, dx"),
    (lambda s: s.x, "fails when it is tried: .* takes 1 positional argument but 3 were given"),
])  # fmt: skip
@pytest.mark.parametrize("closed", [True, False])
def test_a_function_that_returns_no_number_is_refused(function, words, closed):
    words = words.replace("(", r"\(").replace(")", r"\)")
    with pytest.raises(ModelError, match=f"the function of event 'wrong' {words}"):
        integrate(
            spring(closed=closed, k=1.0), 4.0, (1.0, 0.0), events=Event(function, name="wrong")
        )
