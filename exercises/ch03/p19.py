"""3/19: the velocity of a car of an amusement ride in cylindrical components."""

from exercises.devices.amusement_ride import (
    car,
    car_in_time,
    coordinates,
    figure,
    steps_in_time,
)
from exercises.proofs import cylindrical_axes, rate, times
from exercises.steps import Step
from newton_euler import cylindrical


def solve(g):
    ground, P, _ = car(g)
    return {"v": P.velocity(ground)}


def steps(g):
    r, _, z, _ = coordinates(g)
    yield Step("z", z.value, "m", "height of the car at theta = pi/4", "3.5")
    yield Step("z_dot", z.rate, "m/s", "its rate, h sin(2 theta) omega", "3.5")
    yield Step("r", r.value, "m", "distance of the car from the axis, sqrt(R^2 - z^2)", "3.5")
    yield Step("r_dot", r.rate, "m/s", "its rate, -z z'/r", "3.5")


def prove(g):
    P, found = car_in_time(g), steps_in_time(g)
    v = times(cylindrical_axes(P(0)), rate(P))
    return {"v": v} | {key: found[key] for key in ("z", "z_dot", "r", "r_dot")}


def mistakes(g):
    v = solve(g)["v"]
    ground, P, _ = car(g)
    _, theta, z = P.coordinates
    return {
        "constant_r": {"v": cylindrical(ground, "P", g.R, theta, z).velocity(ground)},
        "no_inner_factor": {"v": v.reweighted(radial=0.5, axial=0.5)},
        "r_grows": {"v": v.reweighted(radial=-1)},
    }


def draw(g, ax):
    figure(g, ax)
