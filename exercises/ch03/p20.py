"""3/20: the acceleration of a car of an amusement ride in cylindrical components."""

from exercises.devices.amusement_ride import (
    car,
    car_in_time,
    coordinates,
    figure,
    steps_in_time,
)
from exercises.proofs import cylindrical_axes, second_rate, times
from exercises.steps import Step, terms
from newton_euler import cylindrical


def solve(g):
    ground, P, _ = car(g)
    return {"a": P.acceleration(ground)}


def steps(g):
    r, _, z, _ = coordinates(g)
    yield Step("z_dot", z.rate, "m/s", "rate of the height, h sin(2 theta) omega", "3.5")
    yield Step("r", r.value, "m", "distance of the car from the axis, sqrt(R^2 - z^2)", "3.5")
    yield Step("r_dot", r.rate, "m/s", "its rate, -z z'/r", "3.5")
    yield Step(
        "r_ddot", r.acceleration, "m/s^2", "its second rate, -(z'^2 + z z'' + r'^2)/r", "3.5"
    )
    yield from terms(solve(g)["a"], "a", "m/s^2", "3.5")


def prove(g):
    P, found = car_in_time(g), steps_in_time(g)
    a = times(cylindrical_axes(P(0)), second_rate(P))
    return {"a": a} | {key: found[key] for key in ("z_dot", "r", "r_dot", "r_ddot")}


def mistakes(g):
    a = solve(g)["a"]
    ground, P, _ = car(g)
    _, theta, z = P.coordinates
    return {
        "constant_r": {"a": cylindrical(ground, "P", g.R, theta, z).acceleration(ground)},
        "no_r_ddot": {"a": a.without("radial")},
        "no_coriolis": {"a": a.without("coriolis")},
        # z' and r' are halved, and r'' = -(z'^2 + r'^2)/r is a quarter, as z'' = 0
        "no_inner_factor": {"a": a.reweighted(radial=0.25, coriolis=0.5)},
    }


def draw(g, ax):
    figure(g, ax)
