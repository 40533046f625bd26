"""3/22: the acceleration of a car of an amusement ride in spherical components."""

from exercises.devices import amusement_ride as ride

STEPS = "sin_phi", "cos_phi", "z_dot", "phi_dot", "phi_ddot"
solve, steps, prove, draw = ride.problem_of("a", STEPS, in_spherical=True)


def mistakes(g):
    a = solve(g)["a"]
    vector = a.frame.vector
    return {
        "no_phi_ddot": {"a": a.without("euler_phi")},
        "no_centripetal_phi": {"a": vector(a.x, a.y, a.terms["euler_phi"].z)},
        "no_a_R": {"a": vector(0, a.y, a.z)},
        "wrong_coupling_sign": {"a": a.reweighted(coriolis_theta_phi=-1)},
    }
