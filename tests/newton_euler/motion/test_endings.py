"""Messages about a motion that cannot be followed: the reason, and what to write."""

import re

import pytest

from newton_euler import Event, Model, cos, exp, integrate, sin, sqrt, table, tanh, where
from newton_euler.motion import LongError, MotionError, NoValueError, StickingError, second_order

RTOLS = 1e-6, 1e-9


def motion_of(name, parameters, states, rates, start, t):
    return Model(name, parameters, states, rates), start, t


STICKS = {  # the text of the event, and the motion
    "s.v": motion_of("block", {"mu": 3.0}, ("x", "v"),
        lambda s, p, t: (s.v, where(s.v > 0, -p.mu, p.mu)), (0.0, 3.0), 3.0),
    "s.v - p.belt": motion_of("belt", {"belt": 1.0, "k": 4.0}, ("x", "v"),
        lambda s, p, t: (s.v, -p.k * s.x + where(s.v < p.belt, 3.0, -3.0)), (0.0, 0.0), 5.0),
    "s.T - 20": motion_of("relay", {"a": 2.0, "b": 0.1}, ("T",),
        lambda s, p, t: (where(s.T > 20.0, -p.a, p.b),), (25.0,), 10.0),
    "s.dx": (second_order("slope", {"g": 4.9, "mu": 6.8}, ("x",),
        lambda s, p, t: (p.g - p.mu * s.dx / abs(s.dx),)), (0.0, 3.0), 3.0),
    "s.w": motion_of("hinge", {"c": 0.2}, ("a", "w"),
        lambda s, p, t: (s.w, -sin(s.a) - p.c * where(s.w >= 0, 1.0, -1.0)), (1.5, 0.0), 30.0),
    "s.x - t": motion_of("chase", {"c": 3.0}, ("x",),
        lambda s, p, t: (where(s.x < t, p.c, -p.c),), (-2.0,), 5.0),
    "...": motion_of("slide", {}, ("x", "y"),
        lambda s, p, t: (where(s.x + s.y > 0, -2.0, 1.0), 0.3), (1.0, 1.0), 5.0),
}  # fmt: skip


AT_EACH = [  # the relay takes seconds
    pytest.param(event, rtol, marks=[pytest.mark.slow] * (event == "s.T - 20"))
    for event in STICKS
    for rtol in RTOLS
]


@pytest.mark.parametrize(("event", "rtol"), AT_EACH)
def test_a_motion_that_sticks_is_refused_with_the_event_to_write(event, rtol):
    model, start, t = STICKS[event]
    written = re.escape(f"Event(lambda s, p, t: {event}, then=...)")
    place = event.replace(" - ", " = ") if " - " in event else f"{event} = 0"
    place = "the border of a choice" if event == "..." else place
    with pytest.raises(StickingError, match=f"it sticks at {place}, .* lead back: write {written}"):
        integrate(model, t, start, rtol=rtol)


@pytest.mark.parametrize("sign", [1, -1])
def test_an_exponential_that_is_too_large_is_named(sign):
    """A valve that opens over a millimetre gives exp(3000) on one of its sides."""
    rates = lambda s, p, t: (1.0, 1 / (1 + exp(sign * (s.x - 3.0) / 1e-3)))
    with pytest.raises(MotionError, match=r"too large for a float.* 1/\(1 \+ exp\(x\)\)"):
        integrate(Model("valve", {}, ("x", "q"), rates), 10.0, (0.0, 0.0))
    rates = lambda s, p, t: (1.0, (1 - tanh(sign * (s.x - 3.0) / 2e-3)) / 2)
    found = integrate(Model("valve", {}, ("x", "q"), rates), 10.0, (0.0, 0.0)).end["q"]
    assert found == pytest.approx(3.0 if sign > 0 else 7.0, rel=1e-9)


def test_with_that_event_it_is_followed():
    model, start, t = STICKS["s.v - p.belt"]
    carried = Model("carried", dict(model.parameters), ("x", "v"), lambda s, p, t: (p.belt, 0.0))
    event = Event(lambda s, p, t: s.v - p.belt, then=lambda s, p, t: (carried, (s.x, p.belt)))
    motion = integrate(model, t, start, events=event)
    (found,) = motion.events
    assert motion.end["v"] == 1.0
    assert motion.end["x"] == pytest.approx(found.state["x"] + t - found.t, abs=1e-9)


NO_STICKING = {
    "pole": (lambda s, p, t: (s.x * s.x,), (1.0,), 2.0, "may be singular there", MotionError),
    "pole beside a switch": (lambda s, p, t: (s.x * s.x + where(s.x < 0.5, 1.0, 0.0),), (1.0,), 2.0,
                             "may be singular there", MotionError),
    "attraction": (lambda s, p, t: (-1 / s.x,), (1.0,), 2.0, "singular there", MotionError),
    "overflow at the start": (lambda s, p, t: (-exp(s.x),), (1e3,), 2.0, "range|singular", MotionError),
    "no root at the start": (lambda s, p, t: (exp(-s.x) + sqrt(s.x),), (-1.0,), 2.0,
                             "math domain error; see", NoValueError),
    "before a table": (lambda s, p, t: (exp(-s.x) + table([0.5, 1.0], [1.0, 2.0])(t),), (1.0,), 1.0,
                       "has no value at 0.0; outside='hold' .* at its ends; see", NoValueError),
    "formula without value": (lambda s, p, t: (-1 - sqrt(s.x),), (1.0,), 2.0,
                              "beyond it the rates have no value: math domain error", NoValueError),
    "end of a table": (lambda s, p, t: (table([0.0, 1.0], [1.0, 2.0])(t),), (1.0,), 2.0,
                       r"a table from 0\.0 to 1\.0 has no value at 1\.0", NoValueError),
    "end of a table of a state": (lambda s, p, t: (-table([0.5, 1.0], [1.0, 2.0])(s.x),), (1.0,), 2.0,
                                  r"a table from 0\.5 to 1\.0 has no value at 0\.49", NoValueError),
}  # fmt: skip


@pytest.mark.parametrize("name", NO_STICKING)
def test_a_motion_that_does_not_stick_is_not_reported_as_sticking(name):
    rates, start, t, words, kind = NO_STICKING[name]
    with pytest.raises(kind, match=words) as refusal:
        integrate(Model("q", {}, ("x",), rates), t, start, rtol=1e-6, method="dop853")
    assert "sticks" not in str(refusal.value)
    assert type(refusal.value) is kind


def test_a_motion_of_too_many_steps_is_refused_as_long():
    spring = second_order("spring", {}, ("x",), lambda s, p, t: (-s.x,))
    with pytest.raises(LongError, match="take a shorter time"):
        integrate(spring, 1e9, (1.0, 0.0), method="dop853")


def test_a_switch_that_is_crossed_does_not_stick():
    rates = lambda s, p, t: (s.v, -s.x - where(s.v > 0, 0.01, -0.01) * cos(t) ** 2)
    motion = integrate(Model("swing", {}, ("x", "v"), rates), 10.0, (1.0, 0.0), rtol=1e-6)
    assert motion.error <= 1e-6


@pytest.mark.parametrize("place", [1e3, pytest.param(1e5, marks=pytest.mark.slow), 6.371e6])
@pytest.mark.parametrize("jumps", [False, True], ids=["springs", "jumps"])
def test_a_floor_far_from_the_origin_is_bounced_off_or_refused_for_the_last_digit(place, jumps):
    """The rates are rougher by round-off on the floor than at the start, which is no singularity.
    On a spring it is followed as far as round-off allows.
    """
    k, height = 1000.0, 0.1
    floor = lambda s, p: 3 * p.g if jumps else p.k * (p.place - s.x)
    rates = lambda s, p, t: (s.v, where(s.x < p.place, floor(s, p), 0.0) - p.g)
    model = Model("floor", {"k": k, "place": place, "g": 9.81}, ("x", "v"), rates)
    for rtol in (1e-3, 1e-6, 1e-9):
        try:
            found = integrate(model, 0.5, (place + height, 0.0), rtol)
        except MotionError as error:
            words = str(error)
        else:
            words = ""
            energy = found.end["v"] ** 2 / 2 + 9.81 * (found.end["x"] - place)
            assert jumps or found.end["x"] < place or abs(energy / 0.981 - 1) < 10 * rtol
        assert not words or rtol < 1e-3
        assert "singular" not in words
        assert jumps or "could not be followed" not in words


def test_a_border_known_to_its_last_digit_only_is_named():
    rates = lambda s, p, t: (s.v, where(s.x < p.place, 20.0, -10.0))
    model = Model("floor", {"place": 1e10}, ("x", "v"), rates)
    words = r"the rates change at s\.x = p\.place, which is known to the last digit of 1e\+10 only"
    with pytest.raises(MotionError, match=words):
        integrate(model, 0.5, (1e10 + 0.1, 0.0), 1e-7)
