"""What every method of integration obeys: the steps asked for, stops, and what it reports."""

import numpy as np
import pytest

from newton_euler.motion.methods.dop853 import Dop853
from newton_euler.motion.methods.scipy import DOP853, LSODA, RK45
from newton_euler.motion.methods.splitting import Splitting
from newton_euler.motion.methods.taylor import Taylor
from newton_euler.motion.prepared import prepared_model
from tests.models import SPRING, begun, needs_heyoka

BY_STOPS = {
    "dop853": Dop853,
    **{f"scipy {kind.__name__}": kind for kind in (RK45, DOP853, LSODA)},
    "taylor": pytest.param(Taylor, marks=needs_heyoka),
}
EVERY = {**BY_STOPS, "splitting": Splitting}
STEPPED = {name: kind for name, kind in EVERY.items() if name != "taylor"}  # these go step by step


def over(kinds):
    return pytest.mark.parametrize("method", list(kinds.values()), ids=list(kinds))


def run(method, t1=5.0, **options):
    """A run that has not begun, of x'' = -4 x from x = 1."""
    floors = {} if method is Taylor else {"floors": (1e-3, 1e-3)}
    fixed = {"step": 0.1} if method is Splitting else {}
    return begun(method, prepared_model(SPRING), (1.0, 0.0), t1, **floors, **fixed, **options)


@over(STEPPED)
def test_no_more_steps_are_taken_than_are_asked_for(method):
    one = run(method)
    for limit, done in ((3, 3), (2, 5)):
        one.step(limit)
        assert len(one.step_times) == done + 1
        assert one.step_times[-1] == one.t < 5.0
    one.step()
    assert one.step_times[-1] == one.t == 5.0
    assert one.x == pytest.approx((np.cos(10), -2 * np.sin(10)), abs=3e-3)


@over(BY_STOPS)
def test_steps_end_at_stops_and_at_the_goal_itself(method):
    one = run(method, stops=(0.1, 2.5))
    one.step(1000)
    assert all(min(abs(x - t) for t in one.step_times) < 1e-14 for x in (0.1, 2.5, 5.0))
    assert one.step_times == sorted(set(one.step_times))


@over(STEPPED)
def test_the_scales_are_the_largest_sizes_of_all_steps_whose_ends_are_its_states(method):
    one = run(method)
    one.step()
    states = np.array([one.interpolate(n, np.array(one.step_times[n : n + 1]))[:, 0]
                       for n in range(len(one.step_times) - 1)] + [one.x])  # fmt: skip
    assert one.scales == pytest.approx(np.abs(states).max(axis=0), abs=1e-13)
    for n in (0, 3):
        end = one.interpolate(n, np.array(one.step_times[n + 1 : n + 2]))[:, 0]
        assert end == pytest.approx(states[n + 1], abs=1e-13)


@over({name: kind for name, kind in BY_STOPS.items() if name in ("dop853", "scipy RK45")})
def test_a_fixed_step_is_kept_to_the_goal(method):
    for goal, h, times in (
        (1.0, 0.3, [0.0, 0.3, 0.6, 0.9, 1.0]),
        (8.0, 2.0, [0.0, 2.0, 4.0, 6.0, 8.0]),
        (0.2, 0.3, [0.0, 0.2]),
    ):
        one = run(method, goal, step=h)
        one.step()
        assert one.step_times == pytest.approx(times)
