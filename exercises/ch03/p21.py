"""3/21: the velocity of a car of an amusement ride in spherical components."""

from exercises.devices.amusement_ride import (
    car,
    car_in_time,
    coordinates,
    figure,
    steps_in_time,
)
from exercises.proofs import rate, spherical_axes, times
from exercises.steps import Step
from newton_euler import cos, sin, tan


def solve(g):
    ground, _, P = car(g)
    return {"v": P.velocity(ground)}


def steps(g):
    *_, z, phi = coordinates(g)
    yield Step(
        "sin_phi", sin(phi.value), "1", "sine of the elevation of the arm, z/R", "3.7", "3.24"
    )
    yield Step(
        "cos_phi", cos(phi.value), "1", "cosine of the elevation, sqrt(1 - sin(phi)^2)", "3.7"
    )
    yield Step("z_dot", z.rate, "m/s", "rate of the height, h sin(2 theta) omega", "3.7")
    yield Step("phi_dot", phi.rate, "rad/s", "rate of the elevation, z'/(R cos(phi))", "3.7")


def prove(g):
    P, found = car_in_time(g), steps_in_time(g)
    v = times(spherical_axes(P(0)), rate(P))
    return {"v": v} | {key: found[key] for key in ("sin_phi", "cos_phi", "z_dot", "phi_dot")}


def mistakes(g):
    v = solve(g)["v"]
    phi = coordinates(g)[3].value
    return {
        "z_dot_for_v_phi": {"v": v.reweighted(phi=cos(phi))},
        "no_cosine": {"v": v.reweighted(theta=1 / cos(phi))},
        "phi_from_the_vertical": {"v": v.reweighted(theta=tan(phi), phi=1 / tan(phi))},
    }


def draw(g, ax):
    figure(g, ax, elevation_angle=True)
