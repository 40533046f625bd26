"""The step of finite differences: too large truncates, too small cancels; jets have none (2.4),
(3.1).
"""

import cmath
import math

import mpmath
import numpy as np
import pytest

from newton_euler import at
from newton_euler.accuracy.measurements.baselines import CENTRAL, CENTRAL_SECOND, difference
from newton_euler.algebra.scalars import exp, sin

T = 1.3


def f(t):
    return exp(sin(2 * t)) * t**3


def true(order):
    with mpmath.workdps(30):
        return mpmath.diff(lambda t: mpmath.exp(mpmath.sin(2 * t)) * t**3, mpmath.mpf(T), order)


def first(h):
    return difference(lambda t: (f(t),), T, h, CENTRAL, 1)[0]


def second(h):
    return difference(lambda t: (f(t),), T, h, CENTRAL_SECOND, 2)[0]


def errors(difference, order):
    exact = true(order)
    return {n: abs(difference(10.0**n) / float(exact) - 1) for n in range(-15, 0)}


def test_first_differences_reach_11_digits_at_one_step_and_lose_them_on_either_side():
    error = errors(first, 1)
    best = min(error, key=error.get)
    assert -7 <= best <= -4
    assert 1e-13 < error[best] < 1e-9
    assert error[-1] > 1e-3  # truncation
    assert error[-14] > 1e-4  # cancellation


def test_second_differences_reach_8_digits_at_best_and_are_nonsense_at_1e_minus_9():
    error = errors(second, 2)
    best = min(error, key=error.get)
    assert -5 <= best <= -3
    assert 1e-10 < error[best] < 1e-6
    assert error[-7] > 1e-4
    assert error[-9] > 0.5


def test_halving_the_step_gains_a_factor_of_four_only_where_truncation_rules():
    for quotient, order, wide, narrow in ((first, 1, 1e-2, 1e-8), (second, 2, 1e-2, 1e-6)):
        exact = float(true(order))
        assert abs(quotient(wide) - exact) / abs(quotient(wide / 2) - exact) == pytest.approx(
            4, rel=0.01
        )
        below = [abs(quotient(narrow / 2**k) - exact) for k in range(8)]
        assert below[-1] > below[0]


def test_a_jet_needs_no_step_and_gives_both_rates_to_4_round_offs():
    found = at(f, T)
    assert abs(found.rate / true(1) - 1) < 1e-15
    assert abs(found.acceleration / true(2) - 1) < 1e-15


def test_the_complex_step_too_is_exact_for_a_first_rate_but_not_for_a_second():
    g = cmath.exp(cmath.sin(2 * (T + 1e-30j))) * (T + 1e-30j) ** 3
    assert abs(g.imag / 1e-30 / float(true(1)) - 1) < 1e-15
    h = 1e-10
    g = cmath.exp(cmath.sin(2 * (T + 1j * h))) * (T + 1j * h) ** 3
    assert abs(2 * (f(T) - g.real) / h**2 / float(true(2)) - 1) > 1e-3


@pytest.mark.parametrize("t", [1e-6, 1e-3, 1.0, 1e3, 1e6])
def test_over_twelve_decades_of_t_no_fixed_step_serves_and_the_jet_is_right_to_4_round_offs(t):
    def root(t):
        return t**0.5

    exact = mpmath.diff(mpmath.sqrt, mpmath.mpf(t)), mpmath.diff(mpmath.sqrt, mpmath.mpf(t), 2)
    found = at(root, t)
    assert abs(found.rate / exact[0] - 1) < 1e-15
    assert abs(found.acceleration / exact[1] - 1) < 1e-15
    if t > 1e-3:
        h = 1e-4  # the best step at t = 1
        naive = (root(t + h) - 2 * root(t) + root(t - h)) / h**2
        assert abs(naive / float(exact[1]) - 1) > (1e-9 if t == 1 else 1e-2)


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
