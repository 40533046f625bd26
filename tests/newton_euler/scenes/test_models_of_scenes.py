"""Models of scenes: their exact solutions and invariants against their right-hand sides."""

import mpmath as mp
import pytest
from hypothesis import given
from hypothesis import strategies as st

from newton_euler import moving
from newton_euler.scenes.particles.aircraft import vertical_flight
from newton_euler.scenes.particles.low_pressure import air_near_low
from newton_euler.scenes.particles.space_station import free_body
from newton_euler.scenes.planar.pendulum import physical_pendulum
from tests.kinds import close, rates


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
    "pendulum": physical_pendulum(2.0, 0.5, 0.5, 10.0),
}


@pytest.mark.parametrize("name", MODELS)
@given(x=st.lists(st.floats(0.5, 10), min_size=4, max_size=4))
def test_invariants_have_no_rate(name, x):
    model = MODELS[name]
    x = x[: len(model.states)]
    moved = [moving(q, rate) for q, rate in zip(x, model.derivative(x), strict=True)]
    for invariant in model.invariants:
        assert abs(getattr(model.invariant(invariant, moved), "rate", 0)) < 1e-12 * 8 * 10**3
