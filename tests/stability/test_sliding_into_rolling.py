"""Sliding that turns into rolling: friction as sign(slip) makes a solver chatter or stop; an event
and another model do not (8.6).
"""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from newton_euler import Event, integrate
from newton_euler.chapters.examples.ch08 import rolling_begins, sphere_at
from newton_euler.scenes.planar.sliding_sphere import rolling, sliding

V0, MU, G, R, T = 7.0, 0.2, 10.0, 0.5, 3.0
BEGINS = rolling_begins(V0, MU, G, R)  # at 1 s


goes_on_rolling = lambda s, p, t: (rolling(p.r, p.k), (s.x, s.v, s.omega))
SLIP = lambda s, p, t: s.v + s.omega * p.r  # the velocity of the lowest point
ROLLS = Event(SLIP, then=goes_on_rolling, name="rolling begins")


def thrown(v0, omega0=0.0, rtol=1e-9, method="auto", t=T):
    """A sphere thrown with the speed v0 and a spin, by the engine."""
    sense = math.copysign(1, v0 + omega0 * R)
    return integrate(sliding(MU, G, R, sense=sense), t, (0.0, v0, omega0), rtol, method, ROLLS)


def test_at_the_default_tolerance_the_sphere_never_rolls_and_its_speed_is_wrong_in_the_fourth_digit():
    """With one right-hand side for both regimes; tighter tolerances get stuck on the jump."""

    def rates(t, y):
        friction = -np.sign(y[1] + y[2] * R) * MU * G
        return [y[1], friction, friction / (0.4 * R)]

    _, v, omega = solve_ivp(rates, (0.0, T), (0.0, V0, 0.0)).y[:, -1]
    assert abs(v + omega * R) > 1e-3  # m/s of slip, 2 s after rolling began
    assert 3e-4 < abs(v - BEGINS.v) < 1e-2


def test_with_an_event_and_two_models_it_rolls_to_round_off_in_a_hundred_calls():
    motion = thrown(V0)
    assert motion.events[0].t == pytest.approx(BEGINS.t, abs=4e-16)
    models = [segment.system.model.name for segment in motion.segments]
    assert models == ["sliding sphere", "rolling sphere"]
    assert motion.end["v"] == pytest.approx(5.0, abs=2e-15)
    assert abs(motion.end["v"] + motion.end["omega"] * R) < 4e-15
    assert motion.end["x"] == pytest.approx(sphere_at(T, V0, MU, G, R)[0], abs=4e-15)
    assert motion.cost.calls < 300


@pytest.mark.parametrize("method", ["dop853", "taylor", "scipy DOP853", "scipy RK45"])
def test_every_method_of_the_engine_finds_the_same(method):
    motion = thrown(V0, method=method)
    assert motion.events[0].t == pytest.approx(BEGINS.t, abs=1e-12)
    assert motion.end["x"] == pytest.approx(sphere_at(T, V0, MU, G, R)[0], abs=1e-11)
    assert motion.cost.calls < 1000


@pytest.mark.parametrize("slip0", [1e-3, 1e-6, 1e-9, -1e-9, -1e-6, -1e-3])
def test_beside_rolling_from_the_start_the_instant_is_right_to_the_rounding_of_the_slip(slip0):
    """The slip is a difference of two speeds of 5 m/s, known to 1e-15."""
    motion = thrown(5.0 + slip0, -5.0 / R)
    exact = rolling_begins(5.0 + slip0, MU, G, R, omega0=-5.0 / R, sense=math.copysign(1, slip0))
    assert motion.events[0].t == pytest.approx(exact.t, abs=2e-15 / (3.5 * MU * G))
    assert motion.end["v"] == pytest.approx(exact.v, abs=2e-15)


@pytest.mark.parametrize(
    ("omega0", "v"), [(0.0, 5.0), (30.0, 5 - 2 / 7 * 15), (35.0, 0.0), (40.0, 5 - 2 / 7 * 20)]
)
def test_backspin_rolls_on_stops_dead_or_comes_back(omega0, v):
    motion = thrown(V0, omega0, t=12.0)
    assert motion.end["v"] == pytest.approx(v, abs=4e-15)
    start, end = ({"v": V0, "omega": omega0}, motion.end)
    # about the surface, over the mass
    momentum = [0.4 * R * R * s["omega"] - R * s["v"] for s in (start, end)]
    assert momentum[1] == pytest.approx(momentum[0], abs=1e-14)
