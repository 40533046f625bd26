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
from newton_euler.scenes.particles.projectile import shot
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


MODELS = {
    "flight": vertical_flight(2.0, 9.81),
    "station": free_body(-0.3),
    "low": air_near_low(0.8, 1e-2, rate=0.2),
    "flat": shot("flat", 9.81),
}

each_model = pytest.mark.parametrize("name", MODELS)


@each_model
def test_exact_solutions_start_where_they_should_and_solve_the_equations(name):
    """Differentiated by the product rule, to 26 digits."""
    model = MODELS[name]
    # otherwise sin(0.8) has only 16 digits
    model = model.changed(**{n: mp.mpf(x) for n, x in model.parameters.items() if x})
    start = [mp.mpf(x) / 7 for x in (20, 3, -4, 5, 6, 8)][: len(model.states)]
    small = mp.mpf(10) ** -26
    assert close(model.solution(mp.mpf(0), start), start, small)
    t = mp.mpf(3) / 4
    found = rates(lambda t: model.solution(t, start), t)
    assert close(found, model.derivative(model.solution(t, start), t), small)


@each_model
@given(x=st.lists(st.floats(0.5, 10), min_size=6, max_size=6))
def test_invariants_have_no_rate(name, x):
    model = MODELS[name]
    state = x[: len(model.states)]
    moved = [moving(q, rate) for q, rate in zip(state, model.derivative(state), strict=True)]
    for invariant in model.invariants:
        assert abs(getattr(model.invariant(invariant, moved), "rate", 0)) < 1e-12 * 8 * 10**3
