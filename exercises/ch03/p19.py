"""3/19: the velocity of a car of an amusement ride in cylindrical components."""

from exercises.devices import amusement_ride as ride
from exercises.tools import cylindrical_axes, rate, times
from newton_euler import cylindrical

draw = ride.figure

STEPS = "z", "z_dot", "r", "r_dot"


def solve(g):
    ground, P, _ = ride.car(g)
    return {"v": P.velocity(ground)}


def steps(g):
    yield from ride.steps(g, "3.5", *STEPS)


def prove(g):
    P = ride.car_in_time(g)
    return {"v": times(cylindrical_axes(P(0)), rate(P))} | ride.proved_steps(g, *STEPS)


def mistakes(g):
    v = solve(g)["v"]
    ground, P, _ = ride.car(g)
    _, theta, z = P.coordinates
    return {
        "constant_r": {"v": cylindrical(ground, "P", g.R, theta, z).velocity(ground)},
        "no_inner_factor": {"v": v.reweighted(radial=0.5, axial=0.5)},
        "r_grows": {"v": v.reweighted(radial=-1)},
    }
