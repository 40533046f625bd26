"""3/20: the acceleration of a car of an amusement ride in cylindrical components."""

from exercises.devices import amusement_ride as ride
from exercises.tools import cylindrical_axes, second_rate, terms, times
from newton_euler import cylindrical

draw = ride.figure

STEPS = "z_dot", "r", "r_dot", "r_ddot"


def solve(g):
    ground, P, _ = ride.car(g)
    return {"a": P.acceleration(ground)}


def steps(g):
    yield from ride.steps(g, "3.5", *STEPS)
    yield from terms(solve(g)["a"], "a", "m/s^2", "3.5")


def prove(g):
    P = ride.car_in_time(g)
    a = times(cylindrical_axes(P(0)), second_rate(P))
    return {"a": a} | ride.proved_steps(g, *STEPS)


def mistakes(g):
    a = solve(g)["a"]
    ground, P, _ = ride.car(g)
    _, theta, z = P.coordinates
    return {
        "constant_r": {"a": cylindrical(ground, "P", g.R, theta, z).acceleration(ground)},
        "no_r_ddot": {"a": a.without("radial")},
        "no_coriolis": {"a": a.without("coriolis")},
        # z' and r' are halved, and r'' = -(z'^2 + r'^2)/r is a quarter, as z'' = 0
        "no_inner_factor": {"a": a.reweighted(radial=0.25, coriolis=0.5)},
    }
