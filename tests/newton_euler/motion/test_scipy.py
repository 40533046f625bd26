"""SciPy's methods as steppers: what they are given, where their steps end, what they cost."""

from types import SimpleNamespace

import numpy as np
import pytest

from newton_euler import Model, sqrt
from newton_euler.motion import second_order
from newton_euler.motion.methods.base import MAX_STALLED_STEPS, StepError
from newton_euler.motion.methods.table import METHODS
from newton_euler.motion.prepared import prepared_model
from tests.models import SPRING, begun

NAMES = "DOP853", "RK45", "LSODA", "Radau"


def run(name="RK45", t1=5.0, start=(1.0, 0.0), model=SPRING, **options):
    """A run that has not begun; ``counted`` is how often its right-hand side was called."""
    system, counted = prepared_model(model), []

    def counting(*given):
        counted.append(given)
        return system.folded_rates(*given)

    watched = SimpleNamespace(
        folded_rates=counting,
        constants=system.constants,
        rates=lambda t, x: counting(t, *x, *system.constants),
    )
    kind, floors = METHODS[f"scipy {name}"].stepper, (1e-3,) * len(start)
    one = begun(kind, watched, start, t1, floors=floors, **options)
    one.counted = counted
    return one


def test_a_step_keeps_the_tolerance_of_each_state_over_its_scale_and_its_round_off():
    one = run(start=(3.0, 0.0), noise=(1e-5, 0.0))
    assert one.solver.rtol == 1e-8
    assert list(one.solver.atol) == pytest.approx([3e-8 + 1e-5, 1e-11])
    assert run(tolerance=1e-15).solver.rtol == 2.3e-14  # SciPy accepts nothing smaller


def test_no_step_is_longer_than_its_share_and_after_many_their_progress_is_checked():
    still = second_order("still", {}, ("x",), lambda s, p, t: (0.0 * s.x,))
    one = run(t0=1.0, t1=5.0, longest_part=0.3, model=still)
    one.step()
    assert max(np.diff(one.step_times)) == pytest.approx(1.2)
    one = run(t1=2010.0, step=1.0)
    one.step()
    assert one.checked == MAX_STALLED_STEPS


@pytest.mark.parametrize("name", ["DOP853", "RK45", "LSODA"])
@pytest.mark.parametrize("stops", [(), (1.0, 2.5)])
def test_every_call_is_counted(name, stops):
    """SciPy itself does not count the differences that Radau takes for its matrix."""
    one = run(name, stops=stops)
    one.step()
    assert one.calls == len(one.counted)
    assert one.x == pytest.approx((np.cos(10), -2 * np.sin(10)), abs=1e-6)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("step", [None, 0.1])
@pytest.mark.parametrize(
    "rate",
    [lambda s, p, t: sqrt(s.x), lambda s, p, t: 1 / (s.x + 1), lambda s, p, t: 1e300 * s.x * 1e300],
    ids=["root", "quotient", "infinite"],
)
def test_where_the_rates_have_no_value_no_run_begins(name, step, rate):
    """SciPy's Runge-Kutta methods would search for their first step forever."""
    model = Model("any", {}, ("x",), lambda s, p, t: (rate(s, p, t),))
    with pytest.raises((ArithmeticError, ValueError)):
        run(name, start=(-1.0,), model=model, step=step)


@pytest.mark.parametrize("name", ["RK45", "DOP853"])
def test_a_step_into_where_the_rates_have_no_value_is_refused(name):
    """x = sqrt(1 - 2 t) ends at t = 0.5."""
    model = Model("falls", {}, ("x",), lambda s, p, t: (-1 / sqrt(s.x) / sqrt(s.x),))
    one = run(name, 1.0, start=(1.0,), model=model)
    with pytest.raises(StepError, match="step size"):
        one.step()
    assert one.t == pytest.approx(0.5, abs=1e-6)
