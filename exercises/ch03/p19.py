"""3/19: the velocity of a car of an amusement ride in cylindrical components."""

from exercises.devices import amusement_ride as ride
from newton_euler import Frame, cylindrical

solve, steps, prove, draw = ride.problem_of("v", ("z", "z_dot", "r", "r_dot"))


def mistakes(g):
    v = solve(g)["v"]
    _, P, _ = ride.car(g)
    _, theta, z = P.coordinates
    ground = Frame("ground")
    return {
        "constant_r": {"v": cylindrical(ground, "P", g.R, theta, z).velocity(ground)},
        "no_inner_factor": {"v": v.reweighted(radial=0.5, axial=0.5)},
        "r_grows": {"v": v.reweighted(radial=-1)},
    }
