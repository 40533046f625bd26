"""Air near a low: its closed form, the sense of storms, and steady winds."""

import math

import numpy as np
import pytest

from newton_euler.applications import earth as e
from newton_euler.scenes.particles.low_pressure import air_near_low
from tests.explicit import by_scipy
from tests.kinds import close


@pytest.mark.parametrize("latitude", [0.8, -0.8])
def test_storms_turn_counterclockwise_in_the_north_and_clockwise_in_the_south(latitude):
    """Air at rest is drawn in and turned aside; with friction it spirals into the low."""
    model = air_near_low(latitude, pressure_gradient=1e-8)
    for t in np.linspace(1e3, 2e4, 5):
        x, y, dx, dy = model.solution(t, (1e5, 0.0, 0.0, 0.0))
        assert (x * dy - y * dx) * latitude > 0
    spiral = air_near_low(latitude, pressure_gradient=1e-8, friction=2e-5)
    run = by_scipy(spiral, (1e5, 0.0, 0.0, 0.0), 6e5, rtol=1e-10, atol=1e-6)
    x, y, dx, dy = run.y[:, -1]
    assert math.hypot(x, y) < 1e4
    assert np.all((run.y[0] * run.y[3] - run.y[1] * run.y[2])[1:] * latitude > 0)


@pytest.mark.parametrize("latitude", [0.8, -0.8])
@pytest.mark.parametrize("G", [1e-3, 3e-3, -1e-3])
def test_steady_wind_on_a_circle(latitude, G):
    """Its acceleration is v^2/r toward the centre; on a large circle it is the geostrophic wind."""
    radius = 5e5
    v = e.gradient_wind(G, radius, latitude)
    sense = math.copysign(1, latitude)
    model = air_near_low(latitude, pressure_gradient=G / radius)
    assert close(model.derivative((radius, 0.0, 0.0, sense * v))[2:], (-(v**2) / radius, 0), 1e-15)
    assert math.copysign(1, v) == math.copysign(1, G)
    geostrophic = G / abs(e.coriolis_parameter(latitude))
    assert e.gradient_wind(G, 1e12, latitude) == pytest.approx(geostrophic, rel=1e-3)
    assert abs(e.gradient_wind(abs(G), radius, latitude)) < abs(geostrophic)
