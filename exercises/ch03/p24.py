"""3/24: the acceleration of a ride's car, from spherical to cylindrical components."""

from exercises.devices import amusement_ride as ride
from exercises.tools import cylindrical_axes, second_rate, spherical_axes, times, transposed
from newton_euler import pi
from newton_euler.kinematics import T_phi, apply, transpose

draw = ride.section
STEPS = "z_dot", "phi_dot", "phi_ddot"
follows = {"a": lambda g, T_phi_inv: transformed(g, T_phi_inv)["a"]}


def acceleration(g):
    """The acceleration in spherical components, the elevation, and the cylindrical axes."""
    ground, in_cylindrical, P = ride.car(g)
    return P.acceleration(ground), P.coordinates[2], in_cylindrical.local


def transformed(g, matrix):
    a, _, axes = acceleration(g)
    return {"T_phi_inv": matrix, "a": axes.vector(*apply(matrix, a.components()))}


def solve(g):
    return transformed(g, transpose(T_phi(ride.coordinates(g)[3].value)))


def steps(g):
    a, phi, _ = acceleration(g)
    yield "phi", phi.value
    yield from ride.steps(g, "3.7", *STEPS)
    yield "a_sph", a


def prove(g):
    """The matrix from the unit vectors at the car."""
    P = ride.car_in_time(g)
    here, there, a = spherical_axes(P(0)), cylindrical_axes(P(0)), second_rate(P)
    answers = {"T_phi_inv": times(there, transposed(here)), "a": times(there, a)}
    found = ride.proved_steps(g, "phi", *STEPS)
    return answers | found | {"a_sph": times(here, a)}


def mistakes(g):
    a, phi, axes = acceleration(g)
    phi = phi.value
    return {
        "not_inverted": transformed(g, T_phi(phi)),
        "phi_from_the_vertical": transformed(g, transpose(T_phi(pi(phi) / 2 - phi))),
        "no_phi_ddot": {"a": a.without("euler_phi").expressed_in(axes)},
    }
