"""Shots on the rotating Earth: how far the first order holds, and what the proofs leave out."""

import pytest
from mpmath import mp

from exercises.catalogue import problem
from exercises.ch06 import p21, p22
from exercises.devices.turning_earth import earth_rate, flight
from newton_euler.applications import projectile_to_order

FT = 0.3048


def to_all_orders(g, t, launch):
    ground = launch.frame
    return projectile_to_order(t, launch, -g.g * ground.k, earth_rate(ground), 24)


def test_the_first_order_of_6_21_is_right_to_a_millionth_of_a_foot_to_the_east():
    p = problem("6/21")
    g = p.base(p.book_values)
    phi = p21.elevation(g)
    t, r = p21.landing(g, phi)
    launch = r.frame.vector(0, g.v_0 * mp.cos(phi), g.v_0 * mp.sin(phi))
    error = (r - to_all_orders(g, t, launch)) / FT
    assert abs(error.x) < 1e-6  # of 0.318 ft
    assert abs(error.y) < 1e-4
    assert abs(error.z) < 1e-4


def test_the_first_order_of_6_22_is_right_to_a_millimetre_to_the_east_at_300_metres_per_second():
    g = problem("6/22").base({"v_0": 300.0, "g": 9.81, "omega_e": 7.27e-5, "lat": 0.7})
    r = p22.way(g)
    error = r - to_all_orders(g, 2 * g.v_0 / g.g, g.v_0 * r.frame.k)
    assert r.x == pytest.approx(-20.8, abs=0.01)
    assert abs(error.x) < 1e-3
    assert (
        0.01 < abs(error.y) < 0.1
    )  # of the second order, as the centrifugal part that is left out


def test_a_flight_that_is_seen_from_the_stars_has_the_centrifugal_part_too():
    """Released at rest at the equator: it rises by R omega^2 t^2/2, of second order in omega."""
    g = problem("6/22").base({"v_0": 1.0, "g": 9.81, "omega_e": 1e-4, "lat": 0.0})
    x, y, z = flight(g, [0, 0, 0])(mp.mpf(1), mp.mpf(1))
    assert float(z + g.g / 2) == pytest.approx(6.4e6 * 1e-8 / 2, rel=1e-3)
    assert float(x) == pytest.approx(1e-4 * (g.g - 0.064) / 3, rel=1e-3)
    assert y == 0
