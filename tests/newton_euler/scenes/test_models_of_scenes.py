"""Models of scenes: their exact solutions and invariants against their right-hand sides."""

import math

import mpmath as mp
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import Frame, moving, polar
from newton_euler.dynamics import coordinate_accelerations
from newton_euler.motion.model import second_order
from newton_euler.scenes.particles.aircraft import vertical_flight
from newton_euler.scenes.particles.low_pressure import air_near_low
from newton_euler.scenes.particles.space_station import free_body
from tests.kinds import close, rates


def pendulum(m=1.0, g=9.81, length=2.0):
    """A pendulum from its forces, in polar coordinates, x down; the cord does not affect theta."""

    def accelerations(s, p, t):
        ground = Frame("ground")
        bob = polar(ground, "bob", p.length, moving(s.theta, rate=s.dtheta))
        return coordinate_accelerations(p.m, bob, weight=p.m * p.g * ground.i)[1:]

    return second_order("pendulum", {"m": m, "g": g, "length": length}, ("theta",), accelerations)


def test_the_state_form_follows_from_forces_in_polar_coordinates():
    model = pendulum()
    assert model.states == ("theta", "dtheta")
    assert close(model.derivative((0.4, 1.5)), (1.5, -9.81 / 2 * math.sin(0.4)), 1e-15)
    assert close(model.compiled_rhs()(0.0, 0.4, 1.5), (1.5, -9.81 / 2 * math.sin(0.4)), 1e-15)
    g, length, theta = sympy.symbols("g length theta")
    found = pendulum(1, g, length).derivative((theta, 0))[1]
    assert sympy.simplify(found + g * sympy.sin(theta) / length) == 0


def test_an_aircraft_that_coasts_without_lift_solves_its_equations():
    """Differentiated by the product rule, to 26 digits; the exact solutions of the ladders have a
    test of their own.
    """
    model = vertical_flight(mp.mpf(2), mp.mpf("9.81"))
    start = [mp.mpf(x) / 7 for x in (20, 3, -4, 5)]
    t, small = mp.mpf(3) / 4, mp.mpf(10) ** -26
    assert close(model.solution(mp.mpf(0), start), start, small)
    found = rates(lambda t: model.solution(t, start), t)
    assert close(found, model.derivative(model.solution(t, start), t), small)


MODELS = {
    "flight": vertical_flight(2.0, 9.81),
    "station": free_body(-0.3),
    "low": air_near_low(0.8, 1e-2, rate=0.2),
}


@pytest.mark.parametrize("name", MODELS)
@given(x=st.lists(st.floats(0.5, 10), min_size=4, max_size=4))
def test_invariants_have_no_rate(name, x):
    model = MODELS[name]
    moved = [moving(q, rate) for q, rate in zip(x, model.derivative(x), strict=True)]
    for invariant in model.invariants:
        assert abs(getattr(model.invariant(invariant, moved), "rate", 0)) < 1e-12 * 8 * 10**3
