"""Steps that end where the rates change their formula, against solutions in closed form."""

import math

import pytest

from newton_euler import Model, exp, integrate, sqrt, table, where
from newton_euler.motion import StickingError
from newton_euler.motion.crossings import distances
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from newton_euler.motion.run import Run
from newton_euler.motion.trajectory import Trajectory

TWO_SPRINGS = Model(
    "two springs", {"k": 4.0}, ("x", "v"),
    lambda s, p, t: (s.v, -where(s.x > 0, p.k, 1.0) * s.x))  # fmt: skip


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
    """A hundred times across two springs, back at the start; across kinks it is not."""
    errors = []
    for tolerance in (1e-7, 1e-9, 1e-11):
        trajectory = stopping(TWO_SPRINGS, 15 * math.pi, (1.0, 0.0), tolerance)
        errors.append(abs(trajectory.segments[-1].x1[0] - 1) + abs(trajectory.segments[-1].x1[1]))
    assert 20 < errors[0] / errors[1] < 500
    assert 20 < errors[1] / errors[2] < 500


@pytest.mark.parametrize("rate", [1e-3, 1.0, 300.0])
@pytest.mark.parametrize("rtol", [1e-3, 1e-6, 1e-9, 1e-11])
def test_a_jump_moves_a_state_that_was_zero(rate, rtol):
    """It was refused: no error is small relative to nothing."""
    model = Model(
        "trigger", {"r": rate}, ("x", "q"), lambda s, p, t: (1.0, where(s.x > 5.0, p.r, 0.0)))  # fmt: skip
    motion = integrate(model, 8.0, (0.0, 0.0), rtol)
    assert abs(motion.end["q"] / (3.0 * rate) - 1) <= motion.error <= rtol


def test_a_motion_that_slides_is_refused_with_what_to_write():
    model = Model("relay", {}, ("x",), lambda s, p, t: (where(s.x > 1.0, -2.0, 3.0),))
    for tolerance in (1e-6, 1e-9):
        trajectory = stopping(model, 2.0, (0.0,), tolerance)
        assert trajectory.failed
        assert trajectory.count < 1000
    with pytest.raises(StickingError, match=r"it sticks at s.x = 1, .* write Event"):
        integrate(model, 2.0, (0.0,), 1e-9)


def test_a_run_that_steps_over_a_latch_does_not_contradict_one_that_has_seen_it():
    """By its energy: it was refused since the run for comparison was off by 3e-4."""
    p = {"a": 2.0212371369236255, "w": 0.007133424576294361, "at": 0.2953242156135586, "E": 0.26}

    def rates(s, p, t):
        z = (s.x - p.at) / p.w
        return s.v, -p.a + 2 * p.E / p.w * z * exp(-z * z)

    model = Model("latch", p, ("x", "v"), rates)
    for start in (2.1, 2.3, 2.5):
        t = 1.02 * math.sqrt(2 * (start - p["at"]) / p["a"])
        motion = integrate(model, t, (start, 0.0), 1e-12, "dop853")
        x, v = motion.end.values()
        gone = 2 * p["a"] * (start - x) - 2 * p["E"] * math.exp(-(((x - p["at"]) / p["w"]) ** 2))
        assert abs(v * v - gone) < 1e-12 * gone
