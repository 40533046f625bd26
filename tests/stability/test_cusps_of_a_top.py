"""Cusps, the border between waves and loops: a top released from rest; rounding makes waves or
loops of it (10.25).
"""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from newton_euler.applications.nutation import nutation
from newton_euler.motion.integration import integrate
from newton_euler.scenes.spatial import top
from tests.stability.naive import solved

I0, I, MGR = 0.02, 0.01, 0.5


def rate_at_the_upper_limit(theta, omega_z):
    """psi' there, from the roots of the printed cubic (1 - u^2)(e - A u) - (c - b u)^2 by numpy; it
    should be zero.
    """
    b, A, u0 = I * omega_z / I0, 2 * MGR / I0, math.cos(theta)
    c, e = b * u0, A * u0
    u = np.sort(np.roots([A, -e - b * b, -A + 2 * b * c, e - c * c]).real)[1]
    return (c - b * u) / (1 - u * u)


def test_the_printed_cubic_makes_waves_of_half_of_the_cusps_and_loops_of_the_others():
    random = np.random.default_rng(1)
    cases = zip(random.uniform(0.2, 1.4, 500), random.uniform(60, 200, 500), strict=True)
    rates = np.array([rate_at_the_upper_limit(*case) for case in cases])
    assert 0.3 < np.mean(rates > 0) < 0.7
    assert 0.3 < np.mean(rates < 0) < 0.7


def test_a_run_at_default_tolerance_makes_loops_of_it():
    y = solved(top.euler(I0, I, MGR, 100.0), 20.0, (0.0, 1.0, 0.0, 0.0, 0.0)).y
    assert y[3].min() < -0.01  # rad/s: it runs backwards


@given(st.floats(0.05, 1.5), st.floats(50.0, 1000.0))
def test_the_engine_calls_every_release_from_rest_a_cusp_with_no_rate_at_all(theta, omega_z):
    found = nutation(I0, I, MGR, theta, 0.0, 0.0, omega_z=omega_z)
    assert found.kind == "cusps"
    assert found.precession_at_min == 0.0
    assert found.theta_min == pytest.approx(theta, rel=1e-15)


@pytest.mark.parametrize(("precession", "kind"), [
    (1e-3, "waves"), (1e-6, "waves"), (1e-8, "waves"), (1e-12, "cusps"), (-1e-12, "cusps"),
    (-1e-8, "loops"), (-1e-6, "loops"), (-1e-3, "loops"),
])  # fmt: skip
def test_beside_the_cusp_it_tells_waves_from_loops_and_keeps_the_rate_to_the_last_digit(
    precession, kind
):
    found = nutation(I0, I, MGR, 1.0, 0.0, precession, omega_z=100.0)
    assert found.kind == kind
    assert found.precession_at_min == pytest.approx(precession, rel=1e-15)


def test_with_a_tolerance_of_its_own_it_tells_them_down_to_1e_minus_13():
    kinds = [
        nutation(I0, I, MGR, 1.0, 0.0, x, omega_z=100.0, tolerance=1e-15).kind
        for x in (1e-13, 0.0, -1e-13)
    ]
    assert kinds == ["waves", "cusps", "loops"]


def test_integrated_by_the_engine_it_stops_at_every_cusp_to_1e_minus_9_rad_per_s():
    motion = integrate(
        top.euler(I0, I, MGR, 100.0), 1.0, (0.0, 1.0, 0.0, 0.0, 0.0), 1e-10, samples=4001
    )
    assert -1e-9 < motion.states["psi_rate"].min() < 1e-9
    found = nutation(I0, I, MGR, 1.0, 0.0, 0.0, omega_z=100.0)
    # sampled, at a flat top
    assert motion.states["theta"].max() == pytest.approx(found.theta_max, abs=1e-6)
