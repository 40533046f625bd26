"""Steps that end where the rates change their formula, against solutions in closed form."""

import itertools
import math
import random
from contextlib import suppress

import mpmath
import pytest

from newton_euler import Model, exp, integrate, sqrt, table, where
from newton_euler.motion import AccuracyError, MotionError, StickingError, trajectory
from newton_euler.motion.crossings import distances
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.run import Run
from newton_euler.motion.trajectory import Trajectory

TWO_SPRINGS = Model(
    "two springs", {"k": 4.0}, ("x", "v"), lambda s, p, t: (s.v, -where(s.x > 0, p.k, 1.0) * s.x)
)


def stopping(model, t, start, tolerance, known=None):
    run = Run(prepared_model(model), 0.0, t, start, 1e-9)
    return Trajectory(run, METHODS["dop853"], tolerance, known, stopping=True)


@pytest.mark.parametrize(
    ("rate", "state", "away"),
    [
        (lambda s: where(s.x > 2.0, 1.0, 0.0), 5.0, 3.0),
        (lambda s: abs(s.x - 7.0), 5.0, -2.0),
        (lambda s: s.x + sqrt(s.x * s.x), -0.25, -0.25),
        (lambda s: sqrt(s.x**2), 0.5, 0.5),
        (lambda s: where(s.x * s.x < 9.0, exp(s.x), 0.0), 2.0, -5.0),
    ],
)
def test_the_distance_from_a_place_where_the_formula_changes(rate, state, away):
    model = Model("any", {}, ("x",), lambda s, p, t: (rate(s),))
    (found,) = distances(prepared_model(model))(0.0, (state,))
    assert abs(found) == abs(away)


def test_a_table_of_a_state_changes_its_formula_at_each_place():
    measured = table([1.0, 2.0, 4.0], [0.0, 3.0, 1.0])
    model = Model("measured", {}, ("x",), lambda s, p, t: (measured(s.x),))
    assert distances(prepared_model(model))(0.0, (3.0,)) == [2.0, 1.0, -1.0]


@pytest.mark.parametrize("tolerance", [1e-6, 1e-10, 1e-14])
def test_steps_end_at_every_change_of_a_spring(tolerance):
    trajectory = stopping(TWO_SPRINGS, 9.0, (1.0, 0.0), tolerance)
    changes, t = [], math.pi / 4
    while t < 9.0:
        changes += [t, t + math.pi]
        t += 1.5 * math.pi
    nearest = [min(abs(t - c) for t in trajectory.segments[0].stepper.step_times) for c in changes
               if c < 9.0]  # fmt: skip
    assert len(nearest) > 3
    assert max(nearest) < max(30 * tolerance, 1e-13)


def test_the_error_of_such_steps_is_proportional_to_their_tolerance():
    """Two springs, back at the start after a hundred crossings; steps across kinks do worse."""
    errors = []
    for tolerance in (1e-7, 1e-9, 1e-11):
        trajectory = stopping(TWO_SPRINGS, 15 * math.pi, (1.0, 0.0), tolerance)
        errors.append(abs(trajectory.segments[-1].x1[0] - 1) + abs(trajectory.segments[-1].x1[1]))
    assert 20 < errors[0] / errors[1] < 500
    assert 20 < errors[1] / errors[2] < 500


@pytest.mark.parametrize(("rate", "width"), [(320.0, 0.003), (5.0, 0.2), (1.0, 1.0)])
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9])
def test_a_jump_moves_a_state_that_was_zero(rate, width, rtol):
    """This was once refused: no error is small relative to zero."""
    touched = lambda s, p: where(s.x > p.c, where(s.x < p.c + p.w, p.r, 0.0), 0.0)
    model = Model("hair", {"r": rate, "c": 6.07, "w": width}, ("x", "q"),
                  lambda s, p, t: (2.1, touched(s, p)))  # fmt: skip
    motion = integrate(model, 4.7, (0.0, 0.0), rtol)
    assert abs(motion.end["q"] / (rate * width / 2.1) - 1) <= motion.error <= rtol


def test_a_step_whose_error_estimate_is_small_by_chance_is_judged_by_its_two_halves():
    """A disc of wet ice: within it the speed falls by A per metre of the chord."""
    A, R, start = 1.9939835721474755, 0.19590363586154277, (-1.9241012668165525, 1.9880880989080059)
    u, v, T = 0.5210057588496027, -0.5696466544492487, 7.386103643326437

    def rates(s, p, t):
        wet = where(s.x**2 + s.y**2 - R**2 < 0, A, 0.0)
        return s.u, s.v, -wet * s.u, -wet * s.v

    motion = integrate(Model("wet ice", {}, tuple("xyuv"), rates), T, (*start, u, v), 1e-3)
    aside = (start[0] * v - start[1] * u) / math.hypot(u, v)
    left = math.hypot(u, v) - 2 * A * math.sqrt(R**2 - aside**2)
    assert math.hypot(motion.end["u"], motion.end["v"]) == pytest.approx(left, abs=5e-4)


def test_a_motion_that_slides_is_refused_with_what_to_write():
    model = Model("relay", {}, ("x",), lambda s, p, t: (where(s.x > 1.0, -2.0, 3.0),))
    for tolerance in (1e-6, 1e-9):
        trajectory = stopping(model, 2.0, (0.0,), tolerance)
        assert trajectory.failed
        assert trajectory.count < 1000
    with pytest.raises(StickingError, match=r"it sticks at s.x = 1, .* write Event"):
        integrate(model, 2.0, (0.0,), 1e-9)


@pytest.mark.parametrize("w", [0.06, 0.07, 0.08, 0.2])
def test_a_run_that_steps_over_a_resistance_does_not_contradict_one_that_has_seen_it(w):
    """Judged by the time to reach each speed. This was once refused, with an error of 6e-3."""
    g, vc, A = 9.81, 20.0, 9.0
    rates = lambda s, p, t: (g - A * exp(-(((s.v - vc) / w) ** 2)),)
    motion = integrate(Model("resistance", {}, ("v",), rates), 4.0, (0.0,), 1e-12, "dop853")
    slowness = lambda v: 1 / (g - A * mpmath.exp(-(((v - vc) / w) ** 2)))
    places = [0, *(vc + k * w for k in (-8, -4, -2, -1, 0, 1, 2, 4, 8)), motion.end["v"]]
    with mpmath.workdps(30):
        late = mpmath.quad(slowness, places) - 4
    assert abs(late) * g < 1e-12 * motion.end["v"]


def floor(friction):
    """A block on a spring and a rough floor."""
    return Model("floor", {}, ("x", "v"), lambda s, p, t: (s.v, -s.x - friction(s.v)))


FRICTIONS = {
    "of two directions": lambda v: 0.5 * where(v > 0, 1.0, -1.0),
    "none at rest": lambda v: 0.5 * where(v > 0, 1.0, where(v < 0, -1.0, 0.0)),
}


@pytest.mark.parametrize("friction", FRICTIONS.values(), ids=FRICTIONS)
@pytest.mark.parametrize("x", [2.0, -2.0])
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9, 1e-12])
def test_what_begins_at_a_border_begins_with_the_rates_beside_it(friction, x, rtol):
    motion = integrate(floor(friction), 2.0, (x, 0.0), rtol=rtol)
    centre = math.copysign(0.5, x)
    exact = centre + (x - centre) * math.cos(2.0), -(x - centre) * math.sin(2.0)
    for state, wanted in zip(motion.end.values(), exact, strict=True):
        assert abs(state - wanted) <= rtol * 2.0


@pytest.mark.parametrize("friction", FRICTIONS.values(), ids=FRICTIONS)
def test_where_it_sticks_no_narrow_passages_are_searched_for(friction, monkeypatch):
    near = []
    within = trajectory.within_reach
    monkeypatch.setattr(
        trajectory, "within_reach", lambda s, e: near.append(len(s.near)) or within(s, e)
    )
    passed, passage = [], trajectory.passage
    monkeypatch.setattr(trajectory, "passage", lambda *a: passed.append(a) or passage(*a))
    motion = integrate(floor(friction), 10.0, (2.0, 0.0), rtol=1e-3)
    assert motion.end["v"] == pytest.approx(0.0, abs=2e-3)
    assert max(near) < 100  # of some 20 000 steps
    assert len(passed) < 10


@pytest.mark.one_in(2)
@pytest.mark.parametrize(
    ("x", "t", "rtol"),
    [(1.2, 7.0, 1e-3), (3.3, 20.0, 1e-5), pytest.param(0.3, 10.0, 1e-3, id="from the beginning")],
)
def test_what_sticks_for_a_long_time_is_refused_with_what_to_write(x, t, rtol):
    words = r"sticks at s\.v = 0, .*write Event\(lambda s, p, t: s\.v"
    with pytest.raises(StickingError, match=words) as refused:
        integrate(floor(FRICTIONS["of two directions"]), t, (x, 0.0), rtol=rtol)
    assert refused.value.reached.cost.calls < 5e6


@pytest.mark.one_in(3)
@pytest.mark.parametrize("width", [1e-3, 1e-4, 3e-5, 1e-5, 1e-6])
def test_the_error_covers_what_the_last_digit_of_an_edge_makes(width):
    """A push between two hard edges, narrow beside how far they are; no result is off."""
    inside = lambda s, p: where(s.x < p.c, 0.0, where(s.x > p.c + p.w, 0.0, p.a))
    rng, answered = random.Random(f"push {width}"), 0
    for _ in range(8):
        v, c, part = rng.uniform(0.5, 3.0), rng.uniform(3.0, 7.0), rng.uniform(0.1, 2.0)
        w = 10 * width
        parameters = {"a": part * v * v / w, "c": c, "w": w}
        model = Model("push", parameters, ("x", "v"), lambda s, p, t: (s.v, inside(s, p)))
        with mpmath.workdps(40):
            a, edge = mpmath.mpf(parameters["a"]), mpmath.mpf(c + w)
            u = mpmath.sqrt(mpmath.mpf(v) ** 2 + 2 * a * (edge - mpmath.mpf(c)))
            end = mpmath.mpf(c) / v + (u - v) / a
            T = float(end + 5 / v)
            exact = edge + u * (T - end), u
        for rtol in (1e-9, 1e-11, 1e-12):
            try:
                found = integrate(model, T, (0.0, v), rtol)
            except MotionError:
                continue
            pairs = zip(found.end.values(), exact, strict=True)
            assert max(float(abs(x / y - 1)) for x, y in pairs) <= found.error <= rtol
            answered += 1
    assert answered >= (8 if width > 1e-6 else 1)


FLOORS = {
    "layer": (lambda d, k: k, lambda u, g, k: 2 * u / (k - g), (20.7, 60.0)),
    "spring": (
        lambda d, k: k * d,
        lambda u, g, k: 2 * (math.pi - math.atan(u * math.sqrt(k) / g)) / math.sqrt(k),
        (1e3, 1e5),
    ),
}


@pytest.mark.one_in(4)
@pytest.mark.parametrize("kind", FLOORS)
@pytest.mark.parametrize("place", [1.0, 6.4e6])
def test_a_floor_far_from_zero_throws_back_as_one_at_zero(kind, place):
    """Steps up to an edge there do not change the last digit of a place, or lose a part of it."""
    push, contact, strengths = FLOORS[kind]
    g, answered = 9.0, 0
    for k, height, count in itertools.product(strengths, (0.5, 1.5, 3.0), (1, 4)):
        rates = lambda s, p, t, k=k: (s.v, where(s.x < place, push(place - s.x, k), 0.0) - g)
        u, fall = math.sqrt(2 * g * height), math.sqrt(2 * height / g)
        T = 1.7 * fall + contact(u, g, k) + count * (2 * fall + contact(u, g, k))
        with suppress(AccuracyError):
            motion = integrate(Model(kind, {}, ("x", "v"), rates), T, (place + height, 0.0), 1e-6)
            assert abs(motion.end["v"] - 0.3 * u) <= motion.error * u
            answered += 1
    assert answered >= (12 if kind == "layer" or place == 1.0 else 7)


def test_a_border_very_far_away_is_known_to_its_last_digit_and_nothing_sticks_at_it():
    rates = lambda s, p, t: (s.v, where(s.x < p.place, 20.0, 0.0) - 9.0)
    layer = Model("layer", {"place": 1e9}, ("x", "v"), rates)
    with pytest.raises(AccuracyError, match="ask for rtol"):
        integrate(layer, 4.0, (1e9 + 2.0, 0.0), 1e-6)
