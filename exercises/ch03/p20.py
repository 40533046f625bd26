"""3/20: the acceleration of a car of an amusement ride in cylindrical components."""

from exercises.devices import amusement_ride as ride
from newton_euler import Frame, cylindrical

solve, steps, prove, draw = ride.problem_of("a", ("z_dot", "r", "r_dot", "r_ddot"))


def mistakes(g):
    a = solve(g)["a"]
    _, P, _ = ride.car(g)
    _, theta, z = P.coordinates
    ground = Frame("ground")
    return {
        "constant_r": {"a": cylindrical(ground, "P", g.R, theta, z).acceleration(ground)},
        "no_r_ddot": {"a": a.without("radial")},
        "no_coriolis": {"a": a.without("coriolis")},
        # z' and r' are halved, and r'' = -(z'^2 + r'^2)/r is a quarter, as z'' = 0
        "no_inner_factor": {"a": a.reweighted(radial=0.25, coriolis=0.5)},
    }
