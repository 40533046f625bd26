"""A spin too slow for steady precession: the rates are not real, and the least spin is a double
root (10.33).
"""

import math

import mpmath
import numpy as np
import pytest

from newton_euler.applications.gyroscopes import (
    GyroError,
    least_spin,
    steady_moment,
    steady_precession,
)

I0, I, THETA, MGR = 0.02, 0.01, 0.5, 0.5
LEAST = least_spin(I0, I, THETA, mgr=MGR)


def naive(spin, sqrt):
    a, h = (I0 - I) * math.cos(THETA), I * spin
    return (h - sqrt(h * h - 4 * a * MGR)) / (2 * a)


def test_the_printed_root_gives_nan_an_anonymous_error_or_a_complex_rate():
    with np.errstate(invalid="ignore"):
        assert np.isnan(naive(10.0, np.sqrt))
    with pytest.raises(ValueError, match=r"math domain error|nonnegative"):
        naive(10.0, math.sqrt)
    assert np.iscomplex(np.roots([(I0 - I) * math.cos(THETA), -I * 10.0, MGR])).all()


@pytest.mark.parametrize("above", [1e-2, 1e-6, 1e-10])
def test_just_above_the_least_spin_the_rates_hold_the_top_to_1e_minus_14_of_its_moment(above):
    spin = LEAST * (1 + above)
    found = steady_precession(I0, I, THETA, spin=spin, mgr=MGR)
    for rate in (found.slow, found.fast):
        moment = steady_moment(I0, I, THETA, mpmath.mpf(rate), spin)
        assert abs(moment / (MGR * mpmath.sin(THETA)) - 1) < 1e-14


@pytest.mark.parametrize("below", [1e-2, 1e-6, 1e-10])
def test_just_below_it_refuses(below):
    with pytest.raises(GyroError, match="no steady precession"):
        steady_precession(I0, I, THETA, spin=LEAST * (1 - below), mgr=MGR)
