"""3/18: the end of a telescoping boom, raised on a turning shaft while it extends."""

from exercises.devices.spherical_point import elevation_in_time, local_acceleration
from exercises.devices.telescoping_boom import boom_end, end_in_time, figure
from exercises.tools import rate, second_rate, size, terms
from newton_euler import moving, pi

follows = {"acc_mag": lambda g, a: a.norm()}


def boom(g, time=None):
    """Ground, and the end A, at the instant or another time."""
    t = moving(g.t1 if time is None else time, rate=1)
    return boom_end(g.omega, g.beta_0 + g.b_dot * t, g.l_0 + g.l_2 * t**2)


def with_size(a):
    return {"a": a, "acc_mag": a.norm()}


def solve(g):
    ground, A = boom(g)
    return with_size(A.acceleration(ground))


def steps(g):
    ground, A = boom(g)
    R, _, phi = A.coordinates
    yield from {"phi": phi.value, "phi_dot": phi.rate}.items()
    yield from {"R": R.value, "R_dot": R.rate, "R_ddot": R.acceleration}.items()
    yield from terms(A.acceleration(ground), "a", "in/s^2", "3.7")


def prove(g):
    A = end_in_time(g.omega, lambda t: g.beta_0 + g.b_dot * t, lambda t: g.l_0 + g.l_2 * t**2)
    a, phi = local_acceleration(A, g.t1), elevation_in_time(A)
    R = lambda t: size(A(t))
    return {
        "a": a,
        "acc_mag": size(a),
        "phi": phi(g.t1),
        "phi_dot": rate(phi, g.t1),
        "R": R(g.t1),
        "R_dot": rate(R, g.t1),
        "R_ddot": second_rate(R, g.t1),
    }


def mistakes(g):
    a = solve(g)["a"]
    # the elevation falls from its value at t1: beta was smaller before
    falling = {"beta_0": g.beta_0 + 2 * g.b_dot * g.t1, "b_dot": -g.b_dot}
    exchanged = {"beta_0": pi(g.beta_0) / 2 - g.beta_0, "b_dot": -g.b_dot}
    return {
        "half_of_l_ddot": with_size(a.reweighted(radial=0.5)),
        "beta_as_elevation": solve(g.but(**exchanged)),
        "phi_falls": solve(g.but(**falling)),
        "constant_length": with_size(a.without("coriolis_theta", "coriolis_phi")),
    }


def draw(g, ax):
    figure(ax, *boom(g, g.t1 / 2))
