"""3/21: the velocity of a car of an amusement ride in spherical components."""

from exercises.devices import amusement_ride as ride
from newton_euler import cos, tan

STEPS = "sin_phi", "cos_phi", "z_dot", "phi_dot"
solve, steps, prove, draw = ride.problem_of("v", STEPS, in_spherical=True)


def mistakes(g):
    v = solve(g)["v"]
    phi = ride.coordinates(g)[3].value
    return {
        "z_dot_for_v_phi": {"v": v.reweighted(phi=cos(phi))},
        "no_cosine": {"v": v.reweighted(theta=1 / cos(phi))},
        "phi_from_the_vertical": {"v": v.reweighted(theta=tan(phi), phi=1 / tan(phi))},
    }
