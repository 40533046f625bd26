"""The steps of DOP853: their first length, their bounds, what they cost, and what lies in them."""

import math

import numpy as np
import pytest

from newton_euler import Model, integrate, sqrt
from newton_euler.motion import second_order
from newton_euler.motion.methods.base import MAX_STALLED_STEPS, StepError
from newton_euler.motion.methods.dop853 import GROW, SAFETY, SHRINK, Dop853
from newton_euler.motion.prepared import prepared_model
from tests.models import FALL, SPRING, begun

DECAY = Model("decay", {"c": 3.0}, ("x",), lambda s, p, t: (-p.c * s.x,))
TOL = 1e-8


def run(model=SPRING, start=(1.0, 0.0), t1=5.0, **options):
    """A run that has not begun; ``counted`` is how often its right-hand side was called."""
    one = begun(Dop853, prepared_model(model), start, t1, **options)
    f, constants = one.f
    one.counted = 1  # the call of begin()

    def counting(*given):
        one.counted += 1
        return f(*given)

    one.f = counting, constants
    return one


def lengths(one):
    return [h for _, h, *_ in one.steps]


# -- the length of steps


@pytest.mark.parametrize("size", [1.0, -1e-9, 1e9])
def test_in_the_first_step_the_fastest_state_changes_by_a_fraction_of_its_size(size):
    assert run(DECAY, (size,)).h == pytest.approx(0.5 * TOL**0.125 / 3.0, rel=1e-12)


def test_the_first_step_has_the_scale_of_what_changes():
    pair = Model("pair", {}, ("x", "y"), lambda s, p, t: (-s.x, 1.0 + 0 * s.y))
    usual = 0.5 * TOL**0.125
    assert run(pair, (1.0, 0.0), floors=(0.0, 0.99e-3)).h == pytest.approx(usual)
    assert run(pair, (1.0, 0.0), floors=(0.0, 1.01e-3)).h == pytest.approx(usual * 1.01e-3)
    assert run(pair, (1.0, 1.0)).h == pytest.approx(usual)
    assert run(DECAY, (0.0,), t0=1.0, t1=6.0).h == pytest.approx(5e-3)
    slow = second_order("slow", {}, ("x",), lambda s, p, t: (-1e-9 * s.x,))
    for part, t0 in ((0.4, 0.0), (0.13, 2.0)):
        one = run(slow, (1.0, 1.0), t0=t0, longest_part=part)
        one.step()
        assert max(lengths(one)) == pytest.approx(part * (5.0 - t0), rel=1e-12)
    # long enough to change the time
    assert run(slow, (1.0, 1.0), t0=-1e9 - 1e-6, t1=-1e9).hmax == pytest.approx(1e-4)


def test_a_step_grows_and_shrinks_between_its_bounds():
    one = run(DECAY, (1.0,), t1=1e3)
    one.step(3)
    before, _, x = one.steps[-1]
    one.step(1)
    # from a step far too short
    one.h = 1e-9
    one.step(2)
    assert one.h == pytest.approx(GROW**2 * 1e-9, rel=1e-12)
    # from a step far too long, as often as it takes
    one.h, calls = 100.0, one.counted
    one.step(1)
    tries = (one.counted - calls) // 12
    assert tries > 1
    assert 100.0 * SHRINK ** (tries - 1) <= lengths(one)[-1] <= 100.0 * SAFETY ** (tries - 1)
    assert before < one.t
    assert x > one.x[0]


def test_a_step_on_which_the_rates_have_no_value_is_tried_again_with_a_shorter_one():
    """x = 1 - t: a long step looks beyond t = 1, where the root has no value."""
    root = Model("root", {}, ("x",), lambda s, p, t: (-1 + 1e-30 * sqrt(s.x),))
    one = run(root, (1.0,), t1=9.0)
    one.h = 3.0
    one.step(1)
    assert lengths(one) == [pytest.approx(3.0 * SHRINK)]


@pytest.mark.parametrize(("t0", "t1"), [(-0.9, 0.3), (-2.0, 0.7)])
def test_the_last_step_ends_at_the_goal_though_the_time_is_rounded(t0, t1):
    assert t0 + (t1 - t0) != t1
    one = run(t0=t0, t1=t1, step=9.0)
    one.step()
    assert one.step_times == [t0, one.t] == [t0, t1]


def test_steps_keep_the_tolerance_with_little_to_spare():
    """The largest true error of a step is little less than the tolerance allows."""
    one = run(DECAY, (1.0,), t1=3.0)
    one.step()
    ends = [*one.steps[1:], (one.t, None, *one.x)]
    errors = [
        abs(y - x * math.exp(-3.0 * h)) for (_, h, x), (*_, y) in zip(one.steps, ends, strict=True)
    ]
    assert 1e-4 * TOL < max(errors) < TOL


def test_more_steps_than_are_looked_at_together_are_taken_one_after_the_other():
    one = run(t1=200.0, step=0.07)
    one.step()
    assert len(one.steps) == 2858 > MAX_STALLED_STEPS
    assert one.checked == MAX_STALLED_STEPS
    limited = run(t1=200.0, step=0.03)
    limited.step(2 * MAX_STALLED_STEPS + 500)
    assert len(limited.steps) == 2 * MAX_STALLED_STEPS + 500
    assert one.x[0] == pytest.approx(math.cos(400.0), abs=1e-7)


@pytest.mark.parametrize(("t0", "t1"), [(0.0, 1.0), (1e6, 1e6 + 1), (-1e6, 0.0)])
def test_a_step_that_would_not_change_the_time_is_refused(t0, t1):
    one = run(FALL, (1.0,), t0=t0, t1=t1)
    with pytest.raises(StepError, match="too small"):
        one.step()
    assert one.t - t0 == pytest.approx(0.5, abs=1e-8)


# -- what they cost, and what lies in them


def test_every_call_of_the_right_hand_side_is_counted_and_a_step_is_interpolated_once():
    one = run()
    one.step()
    one.state_at(1.0)
    times = np.array(one.step_times[2:4])
    found = one.interpolate(2, times)
    counted = one.counted
    assert one.calls == counted
    assert one.interpolate(2, times).tolist() == found.tolist()
    assert one.counted == counted
    one.interpolate(3, times)
    assert one.calls == one.counted > counted
    assert one.interpolate(2, times).tolist() == found.tolist()


def test_a_step_to_a_time_is_more_accurate_than_the_interpolation():
    """In the middle of a step of the spring, against its closed form from the start of the step."""
    one = run(step=0.2)
    one.step()
    begin, h, x, v = one.steps[3]
    t = begin + 0.4 * h
    c, s = math.cos(0.8 * h), math.sin(0.8 * h)
    exact = np.array([x * c + v / 2 * s, v * c - 2 * x * s])
    fine = abs(one.state_at(t) - exact).max()
    assert 10 * fine < abs(one.interpolate(3, np.array([t]))[:, 0] - exact).max() < 1e-8


def test_between_steps_past_a_root_of_zero_the_state_is_found_by_shorter_steps():
    """A tank falls to a low level: stages of the interpolation alone are below zero there."""
    model = Model("tank", {"q": 3.2e-3}, ("h",), lambda s, p, t: (p.q - sqrt(s.h),))
    for start in np.linspace(0.53, 0.54, 65):
        coarse, fine = (
            integrate(model, 2.61, (start,), rtol, "dop853", samples=101).states["h"]
            for rtol in (1e-3, 1e-9)
        )
        assert abs(coarse - fine).max() <= 1e-3
