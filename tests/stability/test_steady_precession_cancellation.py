"""The quadratic of steady precession as (I0 - I) cos theta -> 0: the printed root (10.33) cancels."""

import math

import mpmath
import numpy as np
import pytest

from newton_euler.accuracy.measurements.baselines import printed_roots
from newton_euler.applications.gyroscopes import fast_spin, steady_precession

I0, SPIN, MGR = 0.02, 100.0, 0.5


def printed(a, h, c):
    return printed_roots(a, h, c)[0]


def slow(theta, I):
    return steady_precession(I0, I, theta, spin=SPIN, mgr=MGR).slow


def exact(theta, I):
    """The slow root in 30 digits (of 60 that the printed form is given)."""
    with mpmath.workdps(60):
        a, h = (mpmath.mpf(I0) - I) * mpmath.cos(mpmath.mpf(theta)), mpmath.mpf(I) * SPIN
        return printed(a, h, MGR)


@pytest.mark.parametrize(
    ("cosine", "lost"), [(1e-6, 1e-12), (1e-9, 1e-9), (1e-12, 1e-6), (1e-14, 1e-3)]
)
def test_the_printed_root_loses_more_digits_the_nearer_the_axis_is_to_level(cosine, lost):
    theta = math.acos(cosine)
    naive = printed((I0 - 0.01) * math.cos(theta), 0.01 * SPIN, MGR)
    assert abs(naive / exact(theta, 0.01) - 1) > lost
    assert abs(slow(theta, 0.01) / exact(theta, 0.01) - 1) < 4e-16


def test_at_the_level_itself_the_printed_root_is_0_over_0_or_off_by_its_own_size():
    theta = math.pi / 2  # whose cosine is 6e-17
    assert abs(printed((I0 - 0.01) * math.cos(theta), 0.01 * SPIN, MGR) / 0.5 - 1) > 0.5
    with np.errstate(invalid="ignore"):
        assert np.isnan((np.float64(1.0) - np.sqrt(1.0 - 0.0)) / np.float64(0.0))
    assert slow(theta, 0.01) == 0.5  # mgr/(I phi') (10.37), rad/s


def test_a_body_with_equal_moments_has_one_rate_and_the_other_is_infinite():
    found = steady_precession(I0, I0, 0.7, spin=SPIN, mgr=MGR)
    assert found.slow == MGR / (I0 * SPIN)
    assert found.fast == math.inf


@pytest.mark.parametrize("difference", [1e-3, 1e-9, -1e-9, 1e-15])
def test_nearly_equal_moments_are_right_to_4_round_offs(difference):
    I = I0 * (1 - difference)
    assert abs(slow(0.7, I) / exact(0.7, I) - 1) < 1e-15


def test_for_an_array_of_angles_through_the_level_every_slow_rate_is_right_to_4_round_offs():
    theta = math.pi / 2 + np.array([-1e-3, -1e-8, -1e-13, 0.0, 1e-13, 1e-8, 1e-3])
    found = steady_precession(I0, 0.01, theta, spin=SPIN, mgr=MGR).slow
    assert (
        max(
            abs(x / exact(t, 0.01) - 1) for x, t in zip(found.tolist(), theta.tolist(), strict=True)
        )
        < 1e-15
    )


def test_the_error_of_the_fast_spin_formula_is_told_without_cancellation():
    # rad/s: the formula is too small by 5e-11 of itself, and a difference of the two rates knows
    # that to 6 digits only
    spin = 1e6
    found = fast_spin(I0, 0.01, 1.0, spin, mgr=MGR)
    with mpmath.workdps(60):
        a, h = (mpmath.mpf(I0) - 0.01) * mpmath.cos(1), mpmath.mpf(0.01) * spin
        true = printed(a, h, MGR)
        error = (MGR / h - true) / true
    naive = found.slow / steady_precession(I0, 0.01, 1.0, spin=spin, mgr=MGR).slow - 1
    assert abs(naive / error - 1) > 1e-9
    assert abs(found.slow_error / error - 1) < 1e-14
