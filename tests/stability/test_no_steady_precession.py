"""A spin too slow for steady precession: the rates are not real, and the least spin is a double
root (10.33).
"""

import mpmath
import pytest

from newton_euler.applications.gyroscopes import (
    GyroError,
    least_spin,
    steady_moment,
    steady_precession,
)

I0, I, THETA, MGR = 0.02, 0.01, 0.5, 0.5
LEAST = least_spin(I0, I, THETA, mgr=MGR)


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
