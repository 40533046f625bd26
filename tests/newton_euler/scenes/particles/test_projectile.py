"""Models of a projectile against Kepler, who knew nothing of Coriolis: the shot is an ellipse among
the stars about the Earth's centre, found from Kepler's equation to 30 digits or more and seen from
the turning ground.
"""

import math

import mpmath as mp
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from newton_euler import Dimension, Frame
from newton_euler.applications import earth as e
from newton_euler.scenes.particles import projectile as shots
from tests.kinds import close, numbers


def kepler(t, start, latitude, g, rate, radius):
    """Position and velocity of a shot along ground axes: an ellipse, by Kepler's equation."""
    mu = g * radius**2
    c, s = mp.cos(latitude), mp.sin(latitude)
    # ground components to (east, polar, outward)
    east = mp.matrix([[1, 0, 0], [0, c, s], [0, -s, c]])
    r = east * mp.matrix([start[0], start[1], start[2] + radius])
    v = east * mp.matrix(start[3:])
    v = v + rate * mp.matrix([r[2], 0, -r[0]])  # polar axis (0, 1, 0) x r
    r0, v2 = mp.norm(r), (v.T * v)[0]
    a = 1 / (2 / r0 - v2 / mu)
    n, sigma = mp.sqrt(mu / a**3), (r.T * v)[0] / mp.sqrt(mu * a)
    E = mp.findroot(lambda E: E - (1 - r0 / a) * mp.sin(E) + sigma * (1 - mp.cos(E)) - n * t, n * t)
    f, gg = 1 - a / r0 * (1 - mp.cos(E)), t - (E - mp.sin(E)) / n
    moved = f * r + gg * v
    R = mp.norm(moved)
    df, dg = -mp.sqrt(mu * a) / (R * r0) * mp.sin(E), 1 - a / R * (1 - mp.cos(E))
    speed = df * r + dg * v - rate * mp.matrix([moved[2], 0, -moved[0]])
    ca, sa = mp.cos(rate * t), mp.sin(rate * t)
    back = mp.matrix([[ca, 0, -sa], [0, 1, 0], [sa, 0, ca]])
    place, seen = east.T * (back * moved), east.T * (back * speed)
    return (place[0], place[1], place[2] - radius), tuple(seen)


def on_ellipse(t, start, *earth):
    """The position of a shot at ``t``, from floats."""
    place, _ = kepler(mp.mpf(t), [mp.mpf(x) for x in start], *map(mp.mpf, earth))
    return [float(x) for x in place]


def test_the_full_equations_of_motion_hold_on_the_ellipse_to_25_digits():
    latitude, g, rate, radius = earth = numbers("mpmath", "0.8", "9.82", "0.00007292", "6371000")
    start = numbers("mpmath", 10, -20, 30, 300, 200, 500)
    model = shots.shot("full", g, latitude, rate, radius)
    with mp.workdps(70):
        assert close(sum(kepler(mp.mpf(0), start, *earth), ()), start, mp.mpf(10) ** -50)
        for t in (mp.mpf(0), mp.mpf(20)):
            place, velocity = kepler(t, start, *earth)
            second = [mp.diff(lambda x, n=n: kepler(x, start, *earth)[1][n], t) for n in range(3)]
            rates = model.derivative(place + velocity, t)
            assert close(rates, (*velocity, *second), mp.mpf(10) ** -25)


@pytest.mark.parametrize("latitude", [0.0, 0.5, -1.0])
def test_a_body_let_go_lands_as_far_east_as_the_ellipse_says(latitude):
    """(1/3) omega g cos(latitude) t^3: 2.2 cm in 100 m; to 0.35 %, and to 1e-4 with effective g."""
    g, rate, radius, h = 9.82, e.EARTH_RATE, e.EARTH_RADIUS, 100.0
    t = math.sqrt(2 * h / g)
    place = on_ellipse(t, (0.0, 0.0, h, 0.0, 0.0, 0.0), latitude, g, rate, radius)
    east = rate * math.cos(latitude) * g * t**3 / 3
    assert e.projectile(t, 0.0, 0.0, 0.0, latitude, g)[0] == pytest.approx(east, rel=1e-12)
    assert 0.9965 < place[0] / east < 0.9966
    ground = e.ground_frame(e.earth_frame(Frame("stars")), latitude)
    weight, turning = e.effective_gravity(g, ground), e.earth_rate(ground)
    found = e.projectile_position(t, 0 * ground.k, weight, turning)
    assert found.x == pytest.approx(place[0], rel=1e-4)


def simpler(*earth):
    """The models with an exact solution; earth is (g, latitude, rate, radius)."""
    return [shots.shot(rung, *earth) for rung, (*_, exact, _) in shots.RUNGS.items() if exact]


@settings(max_examples=30)
@given(
    st.floats(-1.5, 1.5), st.floats(-math.pi, math.pi), st.floats(0.1, 1.5), st.floats(10, 2000), st.floats(0.01, 1.0), st.sampled_from([1, 40])
)  # fmt: skip
def test_what_is_neglected_is_closely_bounded(latitude, azimuth, elevation, speed, part, faster):
    """Every rung against the ellipse, also on an Earth that turns ``faster``."""
    g, rate, radius = 9.82, 2e-5 * faster, 6.371e6
    t = part * 1.9 * speed * math.sin(elevation) / g
    start = (0.0, 0.0, 0.0, *(speed * x for x in e.launch_direction(azimuth, elevation)))
    exact = on_ellipse(t, start, latitude, g, rate, radius)
    if exact[0] ** 2 + exact[1] ** 2 + (exact[2] + radius) ** 2 < radius**2:
        return  # the bound holds only above the ground
    for model in simpler(g, latitude, rate, radius):
        error = math.dist(model.solution(t, start)[:3], exact)
        assert error <= sum(model.neglected(t, start).values()) * (1 + 1e-9) + 1e-9
    coriolis = shots.shot("flat", g, latitude, rate, radius).neglected(t, start)[shots.CORIOLIS]
    assert coriolis <= 2 * rate * t * (speed * t + g * t * t)


def test_every_model_has_the_units_of_a_motion():
    LENGTH, SPEED, GRAVITY = Dimension(0, 1, 0), Dimension(0, 1, -1), Dimension(0, 1, -2)
    PURE, TIME = Dimension(), Dimension(0, 0, 1)
    start = (LENGTH,) * 3 + (SPEED,) * 3
    for rung in shots.RUNGS:
        model = shots.shot(rung, GRAVITY, PURE, 1 / TIME, LENGTH, 1 / LENGTH)
        rates = model.derivative(start, TIME)
        assert rates[:3] == (SPEED,) * 3
        assert all(a in (0, GRAVITY) for a in rates[3:])
        assert set(model.neglected(TIME, start).values()) <= {LENGTH}
