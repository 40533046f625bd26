"""3/17: the end of a telescoping boom, lowered on a turning shaft."""

from exercises.devices.spherical_point import elevation_in_time, local_acceleration
from exercises.devices.telescoping_boom import boom_end, end_in_time, figure
from exercises.tools import rate, terms
from newton_euler import moving, pi


def boom(g):
    return boom_end(g.omega, moving(g.beta_1, rate=g.b_dot), moving(g.l1, rate=g.l_dot))


def solve(g):
    ground, A = boom(g)
    return {"a": A.acceleration(ground)}


def steps(g):
    ground, A = boom(g)
    _, _, phi = A.coordinates
    yield "phi", phi.value
    yield "phi_dot", phi.rate
    yield from terms(A.acceleration(ground), "a", "in/s^2", "3.7")


def prove(g):
    A = end_in_time(g.omega, lambda t: g.beta_1 + g.b_dot * t, lambda t: g.l1 + g.l_dot * t)
    phi = elevation_in_time(A)
    return {"a": local_acceleration(A), "phi": phi(0), "phi_dot": rate(phi)}


def mistakes(g):
    a = solve(g)["a"]
    return {
        "beta_raises": solve(g.but(b_dot=-g.b_dot)),
        "beta_as_elevation": solve(g.but(beta_1=pi(g.beta_1) / 2 - g.beta_1, b_dot=-g.b_dot)),
        "no_coupling": {"a": a.without("coriolis_theta_phi")},
        "constant_length": {"a": a.without("coriolis_theta", "coriolis_phi")},
    }


def draw(g, ax):
    ground, A = boom(g)
    figure(ax, ground, A).vector(A, A.local.i, r"$\dot l$")
