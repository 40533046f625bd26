"""3/23: the velocity of a car of an amusement ride, from cylindrical to spherical components."""

from exercises.devices import amusement_ride as ride
from exercises.tools import cylindrical_axes, rate, spherical_axes, times, transposed
from newton_euler import pi
from newton_euler.kinematics import T_phi, apply, transpose

draw = ride.section
STEPS = "z_dot", "r", "r_dot"
follows = {"v": lambda g, T_phi: transformed(g, T_phi)["v"]}


def velocity(g):
    """The velocity in cylindrical components, the elevation, and the spherical axes."""
    ground, P, _ = ride.car(g)
    phi = ride.coordinates(g)[3]
    return P.velocity(ground), phi, P.local.rotate("e_R, e_theta, e_phi", "-y", phi)


def transformed(g, matrix):
    v, _, axes = velocity(g)
    return {"T_phi": matrix, "v": axes.vector(*apply(matrix, v.components()))}


def solve(g):
    return transformed(g, T_phi(ride.coordinates(g)[3].value))


def steps(g):
    v, phi, _ = velocity(g)
    yield "phi", phi.value
    yield from ride.steps(g, "3.5", *STEPS)
    yield "v_cyl", v


def prove(g):
    """The matrix from the unit vectors at the car."""
    P = ride.car_in_time(g)
    here, there, v = cylindrical_axes(P(0)), spherical_axes(P(0)), rate(P)
    answers = {"T_phi": times(there, transposed(here)), "v": times(there, v)}
    return answers | ride.proved_steps(g, "phi", *STEPS) | {"v_cyl": times(here, v)}


def mistakes(g):
    v, phi, axes = velocity(g)
    phi = phi.value
    return {
        "transposed": transformed(g, transpose(T_phi(phi))),
        "phi_from_the_vertical": transformed(g, T_phi(pi(phi) / 2 - phi)),
        "no_r_dot": {"v": v.without("radial").expressed_in(axes)},
    }
