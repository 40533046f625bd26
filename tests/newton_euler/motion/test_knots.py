"""Where a method must stop to look: at the ends of pulses in functions of time, nowhere else."""

import math
import random

import pytest

from newton_euler import Model, cos, exp, integrate, sin, table, where
from newton_euler.motion import second_order
from newton_euler.motion.knots import INTERVALS, knots
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model

WIDTH = 10.0 / INTERVALS  # of one interval, in the motions below


def at(force, t0=0.0, t1=10.0, **parameters):
    """The stops of a mass pushed by a force(s, p, t)."""
    model = second_order("pushed", parameters, ("x",), lambda s, p, t: (force(s, p, t) - s.x,))
    return knots(prepared_model(model), t0, t1)


def bump(t, centre, width):
    return exp(-(((t - centre) / width) ** 2))


NO_PULSE = {
    "constant": lambda s, p, t: 1.0,
    "state": lambda s, p, t: sin(s.x),
    "oscillation": lambda s, p, t: sin(3 * t),
    "time itself": lambda s, p, t: t * s.x,
    "decaying": lambda s, p, t: exp(-t) * cos(40 * t),
    "zero": lambda s, p, t: 0 * t,
    "bump in space": lambda s, p, t: 1 + bump(s.x, 0.5, 1e-3),
    "bump that a state moves": lambda s, p, t: bump(t - s.x, 5.0, 0.01),
}


@pytest.mark.parametrize("name", NO_PULSE)
def test_without_a_pulse_nothing_stops_the_motion(name):
    assert at(NO_PULSE[name]) == ()


@pytest.mark.parametrize("width", [1e-3, 1e-2, 0.1])
@pytest.mark.parametrize("factor", [1.0, 1e-9, -1e12])
def test_a_pulse_has_a_beginning_and_an_end(width, factor):
    """Both lie where the pulse has fallen to round-off of its height: exp(-36) is 2e-16."""
    begin, end = at(lambda s, p, t: factor * bump(t, 5.0, width))
    assert 5.0 - 6.5 * width - WIDTH <= begin <= 5.0 - 4.5 * width
    assert 5.0 + 4.5 * width <= end <= 5.0 + 6.5 * width + WIDTH


def test_a_pulse_times_a_state_or_a_rate_is_found_too():
    assert len(at(lambda s, p, t: bump(t, 5.0, 0.01) * s.x)) == 2
    assert len(at(lambda s, p, t: sin(bump(t, 5.0, 0.01) + s.dx))) == 2
    assert len(at(lambda s, p, t: bump(t, 5.0, 0.01) * sin(s.x))) == 2


def test_the_pulses_of_all_rates_are_found_in_order_with_two_ends_each():
    model = Model(
        "two", {"w": 0.02}, ("x", "y"), lambda s, p, t: (bump(t, 8.0, p.w), s.x * bump(t, 2.0, p.w))
    )
    found = knots(prepared_model(model), 0.0, 10.0)
    assert len(found) == 4
    assert list(found) == sorted(found)
    assert [round(t) for t in found] == [2, 2, 8, 8]
    found = at(lambda s, p, t: bump(t, 2.0, 0.01) + bump(t, 8.0, 0.01))
    assert found == pytest.approx([1.94, 2.06, 7.94, 8.06], abs=0.01)


@pytest.mark.parametrize(
    ("states", "rates", "count"),
    [
        ("x", lambda s, p, t: (bump(t, 5.0, 0.01),), 2),
        ("xy", lambda s, p, t: (bump(t, 5.0, 0.01), 1.0), 2),  # the other rate is a number
        ("x", lambda s, p, t: (bump(t - s.x, 5.0, 0.01),), 0),  # of time and a state together
    ],
)
def test_a_rate_of_time_alone_is_looked_at(states, rates, count):
    system = prepared_model(Model("any", {}, tuple(states), rates))
    assert len(knots(system, 0.0, 10.0)) == count
    assert knots(system, 0.0, 10.0) is knots(system, 0.0, 10.0)  # searched for only once


def test_what_has_no_value_here_or_on_the_way_stops_nothing():
    assert at(lambda s, p, t: bump(t, 5.0, 0.01) * (1 / (p.k - 1)), k=1.0) == ()
    assert at(lambda s, p, t: s.x * (1 / (t - 5.0))) == ()
    assert len(at(lambda s, p, t: s.x * (1 / (t - 5.0)) + bump(t, 2.0, 0.01) * s.x)) == 2


def test_a_switch_between_constants_is_stopped_at_within_an_interval():
    begin, end = at(lambda s, p, t: where(t * t > p.on**2, 2.0, 1.0) * s.x, on=math.e)
    assert begin <= math.e <= end
    assert end - begin == pytest.approx(WIDTH)


def test_the_edges_of_a_window_of_time_are_its_stops_to_the_last_digit():
    """A push that is short beside its time is off by its force for what a stop is late."""
    inside = lambda p, t: where(t < p.a, 0.0, where(t > p.b, 0.0, p.f))
    rng = random.Random(5)
    for _ in range(100):
        a, end = rng.uniform(1.0, 9.0), rng.uniform(10.0, 30.0)
        parameters = {"a": a, "b": a + 10.0 ** rng.uniform(-7, -1), "f": 1e6}
        model = Model("window", parameters, ("v",), lambda s, p, t: (inside(p, t) - s.v,))
        found = knots(prepared_model(model), rng.uniform(-1.0, 0.5), end)
        assert {parameters["a"], parameters["b"]} <= set(found)


def test_the_time_and_the_parameters_asked_for_are_looked_at_and_no_others():
    model = Model("pushed", {}, ("x",), lambda s, p, t: (bump(t, 5.0, 0.01) - s.x,))
    system = prepared_model(model)
    spans = (0.0, 4.0), (0.0, 10.0), (6.0, 10.0), (4.0, 10.0), (0.0, 10.0)
    assert [len(knots(system, *span)) for span in spans] == [0, 2, 0, 2, 2]
    rates = lambda s, p, t: (bump(t, p.when, p.width),)
    model = Model("pushed", {"when": 3.0, "width": 0.01}, ("x",), rates)
    for when in (3.0, 7.0):
        begin, end = knots(prepared_model(model.changed(when=when)), 0.0, 10.0)
        assert begin < when < end


def test_a_pulse_that_lasts_to_the_end_has_no_end_and_one_from_the_start_no_beginning():
    (begin,) = at(lambda s, p, t: where(t > 5.0, (t - 5.0) ** 2, 0.0))
    assert begin == pytest.approx(5.0, abs=WIDTH)
    (end,) = at(lambda s, p, t: where(t < 5.0, (t - 5.0) ** 2, 0.0))
    assert end == pytest.approx(5.0, abs=WIDTH)


@pytest.mark.parametrize(("gap", "count"), [(3, 2), (4, 4)])
def test_a_quiet_of_few_intervals_does_not_count(gap, count):
    """Two pulses of one interval each, with ``gap`` quiet intervals between them."""
    first, second = (5000.5 * WIDTH, (5000.5 + 1 + gap) * WIDTH)
    force = lambda s, p, t: where(t * t > first**2, 1.0, 0.0) + where(t * t > second**2, 1.0, 0.0)
    assert len(at(force)) == count


def test_more_than_a_thousand_pulses_are_an_oscillation():
    def comb(pulses):
        # exp(-1e3 (1 - cos)): pulses whose width is 1/20 of their spacing
        return lambda s, p, t: exp(1e3 * (cos(2 * math.pi * pulses * t / 10.0) - 1))

    assert len(at(comb(300))) > 500
    assert at(comb(1200)) == ()


@pytest.mark.parametrize(("intervals", "count"), [(4, 1), (5, 2)])
def test_the_quiet_before_the_first_pulse_and_after_the_last_is_as_long(intervals, count):
    first, last = (intervals + 0.5) * WIDTH, 10.0 - (intervals + 0.5) * WIDTH
    assert len(at(lambda s, p, t: where(t * t > first**2, 1.0, 0.0))) == count
    assert len(at(lambda s, p, t: where(t * t > last**2, 1.0, 0.0))) == count


STEPS = [0.0, 1.5, 1.6, 7.0, 12.0]
CLOCKS = {  # the argument at which a table is read, and the times at which it reaches a step
    "time": (lambda s, p, t: t, (1.5, 1.6, 7.0)),
    "later": (lambda s, p, t: t - 2.0, (2.0, 3.5, 3.6, 9.0)),
    "slower": (lambda s, p, t: (1 + t * p.q) / 2 + 3.0, (7.0,)),
    "backwards": (lambda s, p, t: 8.0 - t, (1.0, 6.4, 6.5, 8.0)),
    "by a divisor": (lambda s, p, t: -(-t / p.q), (1.5, 1.6, 7.0)),
}


@pytest.mark.parametrize("name", CLOCKS)
@pytest.mark.parametrize("kind", ["linear", "previous"])
def test_a_motion_stops_where_a_table_of_time_goes_on_to_its_next_piece(name, kind):
    place, times = CLOCKS[name]
    f = table(STEPS, [1.0, 4.0, -2.0, 0.5, 0.7], kind, "hold")
    found = at(lambda s, p, t: s.x * f(place(s, p, t)), q=1.0)
    assert all(min(abs(t - x) for x in found) < 1e-14 * t for t in times)
    model = second_order("read", {"q": 1.0}, ("x",), lambda s, p, t: (f(place(s, p, t)),))
    assert not prepared_model(model).traced.surprises


@pytest.mark.parametrize("place", [
    lambda s, p, t: s.x, lambda s, p, t: t + s.x, lambda s, p, t: t * t, lambda s, p, t: 1 / t,
    lambda s, p, t: t * s.x, lambda s, p, t: sin(t),
])  # fmt: skip
def test_a_table_read_by_anything_else_is_a_kink(place):
    f = table(STEPS, STEPS, outside="hold")
    model = second_order("read", {}, ("x",), lambda s, p, t: (f(place(s, p, t)),))
    assert prepared_model(model).traced.surprises


SWITCHES = {
    "where": (lambda s, p, t: where(t < p.q, 1.0, s.x), (2.0,)),
    "later or at": (lambda s, p, t: where(t >= 2 * p.q - t, 1.0, s.x), (2.0,)),
    "two": (lambda s, p, t: where(t > 9.0, 2.0, where(t / p.q >= 1.0, s.x, 1.0)), (2.0, 9.0)),
    "corner": (lambda s, p, t: abs(t - p.q) * s.x, (2.0,)),
}


@pytest.mark.parametrize("name", SWITCHES)
def test_a_motion_stops_where_the_clock_changes_the_formula(name):
    rate, times = SWITCHES[name]
    model = second_order("switched", {"q": 2.0}, ("x",), lambda s, p, t: (rate(s, p, t),))
    system = prepared_model(model)
    assert all(min(abs(t - x) for x in knots(system, 0.0, 10.0)) < 1e-14 * t for t in times)
    assert not system.traced.surprises
    assert "choose between formulas" in METHODS["taylor"].unusable_because(system)


@pytest.mark.parametrize("sign", ["<", "<="])
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9, 1e-12])
@pytest.mark.parametrize("t0", [0.0, 1e6])
def test_a_push_from_rest_is_as_accurate_as_requested(t0, rtol, sign):
    before = (lambda t, end: t < end) if sign == "<" else (lambda t, end: t <= end)
    force = lambda s, p, t: where(before(t, p.a), 0.0, where(before(t, p.b), 1.0, 0.0))
    model = second_order("pushed", {"a": t0 + 1.7, "b": t0 + 2.9}, ("x",),
                         lambda s, p, t: (force(s, p, t) - s.x,))  # fmt: skip
    motion = integrate(model, (t0, t0 + 10.0), (0.0, 0.0), rtol=rtol)
    a, b = 10.0 - 1.7, 10.0 - 2.9
    assert abs(motion.end["x"] - (math.cos(b) - math.cos(a))) < (rtol if t0 == 0.0 else rtol + 1e-9)


@pytest.mark.parametrize("method", ["dop853", "scipy DOP853"])
def test_a_jump_of_a_table_costs_no_rejected_steps(method):
    jumps = table([0.0, 1.0, 2.0, 3.0], [1.0, -50.0, 80.0, 3.0], "previous")
    level = table([0.0, 1.0, 2.0, 3.0], [1.0, 1.0, 1.0, 1.0], "previous")
    run = lambda f: integrate(
        Model("pushed", {}, ("v",), lambda s, p, t: (f(t) - 0.1 * s.v,)), 3.0, (0.0,), 1e-6, method
    )
    assert run(jumps).cost.calls < 2.5 * run(level).cost.calls


def test_thousands_of_places_are_passed_in_as_many_steps():
    f = table([n / 400 for n in range(4001)], [(-1.0) ** n for n in range(4001)])
    model = Model("pushed", {}, ("v",), lambda s, p, t: (f(t),))
    motion = integrate(model, 10.0, (1.0,), rtol=1e-6)
    assert motion.end["v"] == pytest.approx(1.0, abs=1e-12)
    assert motion.cost.calls < 200_000
