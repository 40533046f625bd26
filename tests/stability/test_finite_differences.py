"""The step of finite differences: too large truncates, too small cancels; jets have none (2.4),
(3.1).
"""

import math

import mpmath
import numpy as np
import pytest

from newton_euler import at
from newton_euler.algebra.scalars import exp, sin

T = 1.3


def f(t):
    return exp(sin(2 * t)) * t**3


def true(order):
    with mpmath.workdps(30):
        return mpmath.diff(lambda t: mpmath.exp(mpmath.sin(2 * t)) * t**3, mpmath.mpf(T), order)


def test_a_jet_needs_no_step_and_gives_both_rates_to_4_round_offs():
    found = at(f, T)
    assert abs(found.rate / true(1) - 1) < 1e-15
    assert abs(found.acceleration / true(2) - 1) < 1e-15


@pytest.mark.parametrize("t", [1e-6, 1e-3, 1.0, 1e3, 1e6])
def test_over_twelve_decades_of_t_the_jet_is_right_to_4_round_offs(t):
    found = at(lambda t: t**0.5, t)
    for x, order in ((found.rate, 1), (found.acceleration, 2)):
        assert abs(x / mpmath.diff(mpmath.sqrt, mpmath.mpf(t), order) - 1) < 1e-15


def test_over_many_instants_the_worst_error_of_a_fixed_step_is_ten_million_times_that_of_the_jet():
    t = np.linspace(0.1, 3.0, 200)
    found, h = at(f, t), 1e-4
    with mpmath.workdps(30):
        exact = [float(at(f, mpmath.mpf(x)).acceleration) for x in t.tolist()]
    jet = np.max(np.abs(found.acceleration - exact))
    fixed = np.max(np.abs((f(t + h) - 2 * f(t) + f(t - h)) / h**2 - exact))
    assert jet < 1e-12 * max(map(abs, exact))
    assert fixed > 1e6 * jet
    assert math.isfinite(fixed)
