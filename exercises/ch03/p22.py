"""3/22: the acceleration of a car of an amusement ride in spherical components."""

from exercises.devices import amusement_ride as ride
from exercises.tools import second_rate, spherical_axes, terms, times

STEPS = "sin_phi", "cos_phi", "z_dot", "phi_dot", "phi_ddot"


def solve(g):
    ground, _, P = ride.car(g)
    return {"a": P.acceleration(ground)}


def steps(g):
    yield from ride.steps(g, "3.7", *STEPS)
    yield from terms(solve(g)["a"], "a", "m/s^2", "3.7")


def prove(g):
    P = ride.car_in_time(g)
    a = times(spherical_axes(P(0)), second_rate(P))
    return {"a": a} | ride.proved_steps(g, *STEPS)


def mistakes(g):
    a = solve(g)["a"]
    vector = a.frame.vector
    return {
        "no_phi_ddot": {"a": a.without("euler_phi")},
        "no_centripetal_phi": {"a": vector(a.x, a.y, a.terms["euler_phi"].z)},
        "no_a_R": {"a": vector(0, a.y, a.z)},
        "wrong_coupling_sign": {"a": a.reweighted(coriolis_theta_phi=-1)},
    }


def draw(g, ax):
    ride.figure(g, ax, elevation_angle=True)
