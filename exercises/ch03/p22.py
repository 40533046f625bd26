"""3/22: the acceleration of a car of an amusement ride in spherical components."""

from exercises.devices.amusement_ride import (
    car,
    car_in_time,
    coordinates,
    figure,
    steps_in_time,
)
from exercises.proofs import second_rate, spherical_axes, times
from exercises.steps import Step, terms
from newton_euler import sin


def solve(g):
    ground, _, P = car(g)
    return {"a": P.acceleration(ground)}


def steps(g):
    phi = coordinates(g)[3]
    yield Step(
        "sin_phi", sin(phi.value), "1", "sine of the elevation of the arm, z/R", "3.7", "3.24"
    )
    yield Step("phi_dot", phi.rate, "rad/s", "rate of the elevation, z'/(R cos(phi))", "3.7")
    second = "second rate of the elevation, phi'^2 tan(phi) as z'' = 0"
    yield Step("phi_ddot", phi.acceleration, "rad/s^2", second, "3.7")
    yield from terms(solve(g)["a"], "a", "m/s^2", "3.7")


def prove(g):
    P, found = car_in_time(g), steps_in_time(g)
    a = times(spherical_axes(P(0)), second_rate(P))
    return {"a": a} | {key: found[key] for key in ("sin_phi", "phi_dot", "phi_ddot")}


def mistakes(g):
    a = solve(g)["a"]
    vector = a.frame.vector
    return {
        "no_phi_ddot": {"a": a.without("euler_phi")},
        "no_centripetal_phi": {"a": vector(a.x, a.y, a.terms["euler_phi"].z)},
        "no_a_R": {"a": vector(0, a.y, a.z)},
        "wrong_coupling_sign": {"a": a.reweighted(coriolis_theta_phi=-1)},
    }


def draw(g, ax):
    figure(g, ax, elevation_angle=True)
