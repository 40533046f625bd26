"""Loss of contact: a particle that slides down a smooth sphere leaves it; integrated further, the
sphere would pull it along (11.29).
"""

import math
from types import SimpleNamespace

import pytest

from newton_euler import Event, Model, cos, integrate, sin
from newton_euler.chapters.examples.ch08 import ContactError, contact

R, G = 2.0, 10.0
FASTEST = math.sqrt(G * R)  # at the top; from this speed on it never touches the sphere


def _leaves(s, p, t):
    x, z, v = p.R * sin(s.theta), p.R * cos(s.theta), p.R * s.omega
    return FLIGHT.changed(g=p.g, R=p.R), (x, z, v * cos(s.theta), -v * sin(s.theta)), (LANDS,)


# theta from the top
on_sphere = lambda s, p, t: (s.omega, p.g / p.R * sin(s.theta))
in_flight = lambda s, p, t: (s.vx, s.vz, 0, -p.g)
flown = lambda s, p, t: (s.x + s.vx * t, s.z + s.vz * t - p.g * t * t / 2, s.vx, s.vz - p.g * t)
normal_force = lambda s, p, t: p.g * cos(s.theta) - p.R * s.omega**2  # per unit mass
SPHERE = Model("on the sphere", {"g": G, "R": R}, ("theta", "omega"), on_sphere)
FLIGHT = Model("free flight", {"g": G, "R": R}, ("x", "z", "vx", "vz"), in_flight, exact=flown)
LEAVES = Event(normal_force, -1, then=_leaves, name="leaves")
LANDS = Event(lambda s, p, t: s.z + p.R, -1, terminal=True, name="lands")


def leaving(v0, theta0=0.0):
    """The angle at which it leaves, from the energy: 3 cos(theta) = 2 cos(theta0) + v0^2/(g R)."""
    return math.acos((2 * math.cos(theta0) + v0 * v0 / (G * R)) / 3)


def landing(v0, theta0=0.0):
    """Where it lands on the ground on which the sphere lies, in closed form."""
    angle = leaving(v0, theta0)
    v = math.sqrt(G * R * math.cos(angle))
    fall = v * math.sin(angle)
    t = (math.sqrt(fall * fall + 2 * G * R * (1 + math.cos(angle))) - fall) / G
    return R * math.sin(angle) + v * math.cos(angle) * t


def slide(v0, theta0=0.0, method="auto", rtol=1e-9):
    """From the top with speed v0, by the engine, until it lands."""
    return integrate(SPHERE, 20.0, (theta0, v0 / R), rtol, method, LEAVES)


@pytest.mark.parametrize("method", ["auto", "dop853", "taylor", "scipy DOP853"])
@pytest.mark.parametrize("v0", [0.01, 1.0, 3.0])
def test_an_event_and_another_model_let_it_go_and_land_where_the_closed_form_says(method, v0):
    motion = slide(v0, method=method)
    left, landed = motion.events
    assert left.state["theta"] == pytest.approx(leaving(v0), abs=1e-9)
    assert landed.state["x"] == pytest.approx(landing(v0), abs=1e-8)
    models = [segment.system.model.name for segment in motion.segments]
    assert models == ["on the sphere", "free flight"]
    assert motion.error < 1e-9


@pytest.mark.parametrize("below", [0.1, 1e-3, 1e-6, 1e-9])
def test_just_below_the_speed_that_leaves_at_once_it_leaves_at_the_angle_of_the_energy(below):
    """theta = sqrt(2 (1 - cos)): half of the digits of the speed are left near the top."""
    v0 = FASTEST * (1 - below)
    left = slide(v0).events[0]
    assert left.state["theta"] == pytest.approx(leaving(v0), rel=1e-9 + 1e-15 / below)


@pytest.mark.parametrize("above", [1e-9, 1e-3, 0.5])
def test_above_it_no_sign_changes_and_the_force_must_be_asked_for_before_it_refuses_in_words(above):
    v0 = FASTEST * (1 + above)
    force = SPHERE.parameters["g"] - v0 * v0 / R
    words = "the surface would have to pull, so the body has left it; it is in free flight"
    with pytest.raises(ContactError, match=words):
        contact(1.0, 0.4, 0.1, normal=force, mu=0.5, force=0.0)
    at_top = SimpleNamespace(theta=0.0, omega=v0 / R)
    flight, start, _ = _leaves(at_top, SimpleNamespace(g=G, R=R), 0.0)
    flown = integrate(flight, 20.0, start, events=LANDS)
    assert flown.end["x"] == pytest.approx(v0 * math.sqrt(4 * R / G), rel=1e-14)


def test_a_grain_that_rests_on_the_top_stays_and_one_beside_it_leaves_at_two_thirds():
    # an equilibrium, if an unstable one
    assert integrate(SPHERE, 20.0, (0.0, 0.0), events=LEAVES).events == ()
    left = slide(0.0, theta0=1e-6).events[0]
    assert left.state["theta"] == pytest.approx(math.acos(2 / 3), abs=1e-9)
    assert left.t == pytest.approx(math.sqrt(R / G) * math.log(2e6), rel=0.2)
