"""Which models a splitting method can split, how long its steps are, and what it keeps."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from newton_euler import Model
from newton_euler.motion import second_order
from newton_euler.motion.methods.base import LengthError, StepError
from newton_euler.motion.methods.splitting import (
    COMPOSITIONS,
    MAX_STEPS,
    LiePoisson,
    Splitting,
    partition,
    principal_moments,
)
from newton_euler.motion.prepared import prepared_model
from tests.models import SPRING, begun, free_body


def model(rates, *states):
    return prepared_model(Model("any", {"k": 2.0}, states, rates))


def run(order=4, t1=5.0, step=0.1, start=(1.0, 0.0), model=SPRING, tolerance=1e-6, **options):
    """A run that has not begun."""
    options |= {"step": step, "tolerance": tolerance}
    kind, method = LiePoisson if len(start) == 3 else Splitting, SimpleNamespace(order=order)
    return begun(kind, prepared_model(model), start, t1, method=method, **options)


# -- which models


@pytest.mark.parametrize(
    ("rates", "states", "groups"),
    [
        (lambda s, p, t: (s.v, -s.x), "xv", ((0,), (1,))),
        (lambda s, p, t: (s.u, s.v, s.y - s.x, s.x), "xyuv", ((0, 1), (2, 3))),
        (lambda s, p, t: (s.u, s.x, s.v, s.y), "xuyv", ((0, 2), (1, 3))),
        (lambda s, p, t: (s.x, 2.0, s.v, s.y), "vxyz", ((0, 3), (1, 2))),
        # a state unconnected to the others, and a state that no rate depends on
        (lambda s, p, t: (1.0, s.v, -s.x), "zxv", ((0, 1), (2,))),
        (lambda s, p, t: (s.v, -s.x, s.x), "xvz", ((0,), (1, 2))),
        # a state connected only through another one
        (lambda s, p, t: (s.w, s.w, s.x + s.y), "xyw", ((0, 1), (2,))),
        (lambda s, p, t: (s.v, -s.x - s.v), "xv", None),
        (lambda s, p, t: (s.y, s.z, s.x), "xyz", None),
        (lambda s, p, t: (s.v, -s.x + t), "xv", None),
        (lambda s, p, t: (p.k * s.v, -p.k * s.x), "xv", ((0,), (1,))),
    ],
)
def test_a_model_is_split_if_no_rate_depends_on_its_own_group(rates, states, groups):
    found = partition(model(rates, *states))
    assert found == groups if groups is None else tuple(map(set, found)) == tuple(map(set, groups))


@pytest.mark.parametrize(
    "moments", [(1, 2, 3), (3, 1, 2.5), (2, 2, 1), (1, 2, 2), (1, 1, 1), (1e-3, 2, 2)]
)
def test_the_moments_of_a_free_body_are_read_from_its_rates(moments):
    found = principal_moments(prepared_model(free_body(*map(float, moments))))
    part = 3 / sum(moments)
    assert found == pytest.approx([part * x for x in moments], rel=1e-12)


def euler(a, b, c, more=lambda s: 0.0):
    """Rates of the form of Euler's equations, with any constants."""
    return model(lambda s, p, t: (a * s.y * s.z + more(s), b * s.z * s.x, c * s.x * s.y), *"xyz")


@pytest.mark.parametrize("system", [
    euler(1.0, 1.0, 1.0),  # one moment of inertia is zero
    euler(0.5, 0.5, -0.2),  # two equations hold, the third does not
    euler(0.5, 0.5, -0.8 + 1e-9),
    euler(0.5, 0.5, -0.8 - 1e-9),
    euler(1.0, 2.0, -1.0),  # these belong to moments of -1, 2 and 3
    euler(0.5, 0.5, -0.8, lambda s: 1e-9 * s.y * s.y),
    euler(0.5, 0.5, -0.8, lambda s: 1.0),
    euler(0.5, 0.5, -0.8, lambda s: 0.1 * s.x),
    euler(0.5, 0.5, -0.8, lambda s: 1 / (s.y - 1)),
    # rates that look like Euler's at a state or two, or at the start
    euler(0.5, 0.5, -0.8, lambda s: (s.y - 1) * (s.z - 1)),
    euler(0.5, 0.5, -0.8, lambda s: (s.x - 1) * (s.x - 2)),
    model(lambda s, p, t: (0.5 * (1 + t) * s.y * s.z, 0.5 * s.z * s.x, -0.8 * s.x * s.y), *"xyz"),
    prepared_model(SPRING),
])  # fmt: skip
def test_other_rates_are_not_those_of_a_free_body(system):
    assert principal_moments(system) is None
    assert principal_moments(euler(0.5, 0.5, -0.8)) == pytest.approx(
        [3 * x / 3.25 for x in (0.5, 1.5, 1.25)]
    )


# -- the length of steps


@pytest.mark.parametrize("order", COMPOSITIONS)
def test_the_parts_of_a_step_are_symmetric_and_cancel_up_to_its_order(order):
    weights = COMPOSITIONS[order]
    assert weights == weights[::-1]
    assert sum(weights) == pytest.approx(1.0, abs=1e-14)
    for power in range(3, order, 2):
        assert sum(w**power for w in weights) == pytest.approx(0.0, abs=1e-10)


@pytest.mark.parametrize(
    ("t1", "step", "count"), [(1.0, 0.3, 4), (1.0, 0.25, 4), (1.1, 0.1, 11), (0.1, 0.3, 1)]
)
def test_steps_are_equal_and_no_longer_than_asked_for(t1, step, count):
    one = run(t0=-1.0, t1=t1 - 1.0, step=step)
    one.step()
    assert len(one.step_times) == len(one.steps) == count + 1
    assert one.calls == 3 * len(COMPOSITIONS[4]) * count
    assert np.diff(one.step_times) == pytest.approx(t1 / count, rel=1e-12)
    assert one.t == one.step_times[-1] == t1 - 1.0


def test_states_beyond_all_bounds_and_too_many_steps_are_refused():
    run(t1=1.0, step=1.01 / MAX_STEPS)
    words = r"3e\+06 steps of order 4 would be needed; take a higher"
    with pytest.raises(LengthError, match=words):
        run(t1=1.0, step=0.99 / MAX_STEPS)
    up = second_order("up", {}, ("x",), lambda s, p, t: (1e200 * s.x,))
    with pytest.raises(StepError, match="the states have become infinite"):
        run(model=up).step()


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
@pytest.mark.parametrize("start", [(1.0, 0.0), (0.0, 2.0), (-0.7, 1.4)])
def test_the_step_is_a_fraction_of_a_radian_of_the_fastest_oscillation(start, size):
    start = [size * x for x in start]
    one = run(step=None, start=start, floors=(1e-3 * size, 1e-3 * size), tolerance=1e-8)
    assert one.h == pytest.approx(0.5 * 1e-8**0.25, rel=0.06)


def test_where_nothing_changes_the_step_is_a_fraction_of_the_time_and_zero_is_no_size():
    drift = second_order("drift", {}, ("x",), lambda s, p, t: (0.0 * s.x,))
    one = run(2, step=None, start=(1.0, 1.0), model=drift, t0=2.0, t1=10.0, tolerance=1e-4)
    assert one.h == pytest.approx(2.0 * 1e-4**0.5)
    # its scale serves only to judge its error
    fast = Model("fast", {}, ("x", "y"), lambda s, p, t: (1.0 + 0 * s.y, 1e6 * s.x))
    for y, times in ((0.0, 2.0), (1.0, 1e-3)):
        options = {"floors": (0.0, 1e-3), "t1": 8.0, "tolerance": 1e-4}
        one = run(2, step=None, start=(1.0, y), model=fast, **options)
        assert one.h == pytest.approx(times * 1e-4**0.5, rel=1e-3)


# -- the states


@pytest.mark.parametrize("order", [4, 8])
def test_states_between_steps_are_those_of_a_shorter_step(order):
    one = run(order, step=0.05)
    one.step()
    times = np.array([0.0, 0.01, 0.05, 1.234, 4.99, 5.0])
    exact = np.array([np.cos(2 * times), -2 * np.sin(2 * times)])
    assert abs(one.states(times) - exact).max() < {4: 2e-4, 8: 2e-7}[order]
    assert one.state_at(1.234) == tuple(one.states([1.234])[:, 0].tolist())
    assert one.scales == pytest.approx((1.0, 2.0), rel=1e-3)


@pytest.mark.parametrize("order", COMPOSITIONS)
def test_a_motion_that_is_turned_round_comes_back(order):
    there = run(order, 5.0)
    there.step()
    x, v = there.x
    back = run(order, 5.0, start=(x, -v))
    back.step()
    assert back.x == pytest.approx((1.0, 0.0), abs=1e-12)


@pytest.mark.parametrize("order", COMPOSITIONS)
def test_a_body_keeps_its_angular_momentum_and_comes_back(order):
    body, start = free_body(), (0.3, 1.0, -0.2)
    there = run(order, 6.0, 0.1, start, body)
    there.step()
    momenta = [math.hypot(x, 2 * y, 3 * z) for x, y, z in (start, there.x)]
    assert momenta[0] == pytest.approx(momenta[1], rel=1e-14)
    back = run(order, 6.0, 0.1, tuple(-x for x in there.x), body)
    back.step()
    assert back.x == pytest.approx([-x for x in start], abs=1e-12)
