"""Cusps, the border between waves and loops: a top released from rest, which rounding turns into
waves or loops (10.25).
"""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from newton_euler.applications.nutation import nutation
from newton_euler.scenes.spatial import top
from tests.stability.naive import solved

I0, I, MGR = 0.02, 0.01, 0.5


def test_a_run_at_default_tolerance_makes_loops_of_it():
    y = solved(top.euler(I0, I, MGR, 100.0), 20.0, (0.0, 1.0, 0.0, 0.0, 0.0)).y
    assert y[3].min() < -0.01  # rad/s: it runs backwards


@given(st.floats(0.05, 1.5), st.floats(50.0, 1000.0))
def test_the_engine_calls_every_release_from_rest_a_cusp_with_no_rate_at_all(theta, omega_z):
    found = nutation(I0, I, MGR, theta, 0.0, 0.0, omega_z=omega_z)
    assert found.kind == "cusps"
    assert found.precession_at_min == 0.0
    assert found.theta_min == pytest.approx(theta, rel=1e-15)


@pytest.mark.parametrize(("precession", "kind", "setting"), [
    *[(10.0**-n, "waves", {}) for n in (3, 6, 8)], *[(-(10.0**-n), "loops", {}) for n in (3, 6, 8)],
    (1e-12, "cusps", {}), (-1e-12, "cusps", {}), (1e-13, "waves", {"tolerance": 1e-15}),
    (-1e-13, "loops", {"tolerance": 1e-15}),
])  # fmt: skip
def test_beside_the_cusp_it_tells_waves_from_loops_and_keeps_the_rate_to_the_last_digit(
    precession, kind, setting
):
    found = nutation(I0, I, MGR, 1.0, 0.0, precession, omega_z=100.0, **setting)
    assert found.kind == kind
    assert found.precession_at_min == pytest.approx(precession, rel=1e-15)
