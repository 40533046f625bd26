"""3/21: the velocity of a car of an amusement ride in spherical components."""

from exercises.devices import amusement_ride as ride
from exercises.tools import rate, spherical_axes, times
from newton_euler import cos, tan

STEPS = "sin_phi", "cos_phi", "z_dot", "phi_dot"


def solve(g):
    ground, _, P = ride.car(g)
    return {"v": P.velocity(ground)}


def steps(g):
    yield from ride.steps(g, "3.7", *STEPS)


def prove(g):
    P = ride.car_in_time(g)
    return {"v": times(spherical_axes(P(0)), rate(P))} | ride.proved_steps(g, *STEPS)


def mistakes(g):
    v = solve(g)["v"]
    phi = ride.coordinates(g)[3].value
    return {
        "z_dot_for_v_phi": {"v": v.reweighted(phi=cos(phi))},
        "no_cosine": {"v": v.reweighted(theta=1 / cos(phi))},
        "phi_from_the_vertical": {"v": v.reweighted(theta=tan(phi), phi=1 / tan(phi))},
    }


def draw(g, ax):
    ride.figure(g, ax, elevation_angle=True)
