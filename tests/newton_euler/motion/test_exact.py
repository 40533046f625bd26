"""The closed form as a method, and the parts of the estimate of its error; the whole estimate is
tested against the truth in tests/stability/test_phase_of_closed_forms.py.
"""

import math

import numpy as np
import pytest
from mpmath import mp, mpf

from newton_euler import Model, cos, sin, sqrt, where
from newton_euler.motion.methods import exact as method
from newton_euler.motion.prepared import PreparedModel, prepared_model
from tests.models import begun


def spring(off=lambda t: 0.0 * t, part=1.0):
    """A spring whose formula for the position is wrong by ``off``, or by the factor ``part``."""

    def solution(s, p, t):
        x, v = part * s.x, part * s.v
        return x * cos(t) + v * sin(t) + off(t), v * cos(t) - x * sin(t)

    return PreparedModel(
        Model("spring", {}, ("x", "v"), lambda s, p, t: (s.v, -s.x), exact=solution)
    )


def test_the_closed_form_is_one_step_in_which_every_state_is_exact():
    one = begun(method.Exact, spring(), (1.0, 0.0), 3.0, 1.0)
    one.step()
    assert (one.t, one.step_times, one.calls) == (3.0, [1.0, 3.0], 1)
    assert one.x == pytest.approx((math.cos(2.0), -math.sin(2.0)), abs=1e-15)
    assert one.state_at(1.5) == pytest.approx((math.cos(0.5), -math.sin(0.5)), abs=1e-15)
    assert one.calls == 2
    times = np.array([1.0, 1.25, 3.0])
    exact = np.array([np.cos(times - 1), -np.sin(times - 1)])
    assert abs(one.interpolate(0, times) - exact).max() < 1e-15
    assert one.calls == 5


# -- the error of one evaluation


@pytest.mark.parametrize(("t", "pace"), [(100.0, 0.01), (0.01, 100.0), (0.0, 1.0)])
def test_where_nothing_changes_the_pace_is_that_of_the_time(t, pace):
    still = Model("still", {}, ("x",), lambda s, p, t: (0.0,), exact=lambda s, p, t: (s.x,))
    assert method._size_and_pace(prepared_model(still), t, (3.0,), (3.0,)) == ((3.0,), pace)


def test_sizes_and_pace_are_the_largest_on_the_way():
    """The velocity is zero at both ends of a whole turn."""
    start, t = (2.0, 0.0), 2 * math.pi
    size, pace = method._size_and_pace(spring(), t, start, start)
    assert size == pytest.approx([2.0, 2.0], rel=0.02)
    assert pace == pytest.approx(1.0, rel=0.02)


@pytest.mark.parametrize("count", [3, 8])
def test_numbers_move_in_directions_that_have_nothing_to_do_with_each_other(count):
    lines = method._lines(count)
    assert len(set(lines)) == method.LINES
    assert np.linalg.matrix_rank(np.array(lines)) == min(count, method.LINES)
    moves = [n for line in lines for n in line]
    assert all(1 <= abs(n) <= method.FARTHEST for n in moves)
    assert min(moves) < 0 < max(moves)


def residual_of(system, t=20.0, start=(1.0, 0.0)):
    size, pace = method._size_and_pace(system, t, start, system.solution(t, start))
    return method.residual(system, t, start, size, pace)


@pytest.mark.parametrize("t", [0.05, 2.0, 20.0, 1e4])
def test_a_solution_has_no_residual(t):
    assert residual_of(spring(), t) == [0.0, 0.0]


def test_a_formula_that_does_not_start_at_the_start_has_that_error():
    assert residual_of(spring(part=1 + 0.5 * method.LEAST_RESIDUAL)) == [0.0, 0.0]
    assert residual_of(spring(part=1 + 1e-8)) == [pytest.approx(1e-8), 0.0]


@pytest.mark.parametrize("off", [
    lambda t: 1e-7 * t,
    # small at the start, and later too small beside what the phase leaves by then
    lambda t: 1e-6 * where(t < 1, t * t, 2 * t - 1),
    lambda t: 1e-6 * where(t < 3, 0.0 * t, (t - 3) ** 2),
], ids=["always", "soon", "later"])  # fmt: skip
@pytest.mark.parametrize("t", [8.0, 20.0])
def test_a_formula_that_is_a_little_wrong_is_found_by_its_rates(off, t):
    """The residual is at least as large as the error of the formula at the end."""
    found = residual_of(spring(off), t)
    assert found[0] > 1e-7
    assert found[0] >= off(t)


@pytest.mark.parametrize("small", [1e-3, 1e-6, 5e-7, 2e-7, 1e-7, 3e-8, 1e-13, 0.0])
def test_a_formula_that_is_the_same_for_all_numbers_near_but_not_right_is_found(small):
    """A spaceship under constant force: c^2/a (sqrt(1 + (a t/c)^2) - 1); a t^2/2 if it is small."""
    rates = lambda s, p, t: (s.v / sqrt(1 + (small * s.v) ** 2), 1 + 0 * s.v)

    def exact(s, p, t):
        u = (small * (s.v + t)) ** 2
        return (
            (s.x + (sqrt(1 + u) - 1) / small**2, s.v + t) if small else (s.x + t * t / 2, s.v + t)
        )

    ship = prepared_model(Model("ship", {}, ("x", "v"), rates, exact=exact))
    x1 = ship.solution(1.0, (0.0, 0.0))
    with mp.workdps(60):
        true = float(1 / (1 + mp.sqrt(1 + mpf(small) ** 2)))
    assert method.estimated_error(ship, 1.0, (0.0, 0.0), x1) >= abs(x1[0] / true - 1)
    if small in (1e-3, 0.0):
        assert method.estimated_error(ship, 1.0, (0.0, 0.0), x1) < 1e-8


def test_a_formula_that_goes_wrong_only_at_the_end_is_found_if_that_is_much():
    late = lambda t: where(t < 19, 0.0 * t, t - 19)
    assert residual_of(spring(late))[0] > 1.0
    assert residual_of(spring(lambda t: 1e-5 * late(t))) == [0.0, 0.0]
