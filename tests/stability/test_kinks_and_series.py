"""A series passes a place where the rates change their formula as if nothing changed: dry friction
by ``where``, drag by sqrt(v*v)*v, a tank that runs empty and "refills".

Every returned motion is checked against the accuracy asked for, whatever ran before.
"""

import importlib.util
import math

import mpmath
import numpy as np
import pytest

from newton_euler import Model, prepare, sin, sqrt, where
from newton_euler.motion import AccuracyError, ModelError, integrate, second_order
from newton_euler.motion.prepared import prepared_model
from tests.honesty import closed_forms
from tests.models import needs_heyoka

HEYOKA = importlib.util.find_spec("heyoka") is not None
RTOL = 1e-9


def friction():
    """A mass on a spring and a rough floor: it swings about +-mu/k and stops after 3.4 s."""
    acceleration = lambda s, p, t: (-p.k * s.x - where(s.dx > 0, p.mu, -p.mu),)
    model = second_order("rough floor", {"k": 4.0, "mu": 0.3}, ("x",), acceleration)
    # half a swing takes pi/2: from 1 to the left, about +0.075; back about -0.075; then as at first
    t, turns = 3.4, 2
    end = 0.075 + (1.0 - 2 * 0.075 * turns - 0.075) * math.cos(2 * (t - turns * math.pi / 2))
    return model, t, (1.0, 0.0), end


def drag():
    """A throw upwards with the drag sqrt(v*v)*v: its velocity by tan, then tanh."""
    rates = lambda s, p, t: (s.v, -p.g - p.c * sqrt(s.v * s.v) * s.v)
    model = Model("throw", {"g": 10.0, "c": 0.1}, ("y", "v"), rates)
    up = math.atan(12.0 / 10.0)  # the terminal velocity is 10, and g over it is 1
    return model, 3.0, (0.0, 12.0), -10.0 * math.tanh(3.0 - up)


def tank():
    """It is empty after 2 s; the formula goes on to a parabola that fills it again."""
    return Model("tank", {"c": 1.0}, ("h",), lambda s, p, t: (-p.c * sqrt(s.h),)), 3.0, (1.0,), 0.0


@pytest.mark.parametrize("method", ["auto", "dop853", "scipy DOP853"])
def test_a_mass_on_a_rough_floor_ends_where_it_does_at_every_time(method):
    model, t, start, end = friction()
    for _ in range(60 if method == "auto" else 1):  # auto used to change its method
        motion = integrate(model, t, start, RTOL, method)
        assert abs(motion.end["x"] - end) <= motion.error <= RTOL
    if HEYOKA:
        prepared_model(model).traced.seconds = 1e3  # as after an hour of such calls
        assert abs(integrate(model, t, start, RTOL).end["x"] - end) <= RTOL


def test_a_throw_with_drag_by_a_root_comes_down():
    model, t, start, end = drag()
    for seconds in (0.0, 1e3):
        prepared_model(model).traced.seconds = seconds
        motion = integrate(model, t, start, RTOL)
        assert abs(motion.end["v"] - end) <= motion.error * 13 <= RTOL * 13
    assert abs(prepare(model, RTOL)(t, start)[1] - end) <= 13 * RTOL


@pytest.mark.parametrize("method", ["auto", "dop853", "taylor"])
def test_an_empty_tank_stays_empty_or_is_refused(method):
    model, t, start, end = tank()
    for seconds in (0.0, 1e3):
        prepared_model(model).traced.seconds = seconds
        try:
            motion = integrate(model, t, start, 1e-6, method)
        except ModelError:
            continue
        assert abs(motion.end["h"] - end) <= 1e-6


@needs_heyoka
def test_a_series_refuses_rates_that_choose_between_formulas():
    model, t, start, _ = friction()
    for ask in (
        lambda: integrate(model, t, start, RTOL, "taylor"),
        lambda: prepare(model, RTOL, "taylor"),
        lambda: integrate(model, t, (np.linspace(0.5, 1.5, 70), 0.0), RTOL, "taylor"),
    ):
        with pytest.raises(ModelError, match=r"choose between formulas by where.*method='auto'"):
            ask()


@needs_heyoka
def test_a_series_that_passed_a_kink_is_refused():
    model, t, start, end = drag()
    with pytest.raises(AccuracyError, match="and rtol = 1e-09 was requested") as refused:
        integrate(model, t, start, RTOL, "taylor")
    motion = refused.value.reached
    assert motion.error >= abs(motion.end["v"] - end) / 13 > RTOL


@pytest.mark.parametrize("count", [5, 80])
def test_batches_are_compared_with_what_was_asked(count):
    model, t, _, _ = friction()
    x = np.linspace(0.9, 1.1, count)
    motions = integrate(model, t, (x, 0.0), 1e-7)
    assert motions.error.shape == (count,)
    assert (motions.error <= 1e-7).all()
    for n in (0, count // 2, count - 1):
        one = integrate(model, t, (float(x[n]), 0.0), 1e-10)
        assert abs(motions.states["x"][n, -1] - one.end["x"]) <= 1e-7 * 1.1


@needs_heyoka
def test_each_motion_of_a_large_batch_has_its_error_even_beside_a_separatrix():
    """Amplitudes up to 1e-7 short of upright: the closest ones cannot be had."""
    model = second_order("pendulum", {}, ("a",), lambda s, p, t: (-sin(s.a),))
    a = np.concatenate([np.linspace(0.1, 3.0, 70), math.pi - 10.0 ** -np.arange(1.0, 8.0)])
    words = r"of 77 motions are not as accurate.* number 7\d"
    with pytest.raises(AccuracyError, match=words) as raised:
        integrate(model, 20.0, (a, 0.0), 1e-11)
    motions = raised.value.reached
    assert (motions.error <= 1e-11).sum() >= 70
    for n in (0, 35, 69, 70, 72, 74, 76):
        with mpmath.workdps(30):
            start = mpmath.mpf(float(a[n]))
            true, _ = closed_forms.pendulum(mpmath, mpmath.mpf(1), start, mpmath.mpf(0), 20)
        error = abs(motions.states["a"][n, -1] - float(true)) / a[n]
        assert error <= (1 if motions.error[n] <= 1e-11 else 10) * motions.error[n]
