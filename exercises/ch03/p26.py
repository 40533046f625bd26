"""3/26: a crane that revolves while its boom is lowered, in spherical components about O."""

from exercises.devices.crane import crane, figure, tip_in_time
from exercises.devices.spherical_point import elevation_in_time
from exercises.tools import rate, second_rate, size, spherical_axes, terms, times
from newton_euler import Frame, moving, pi, spherical


def tip(g):
    """The elevation of the boom, and velocity and acceleration of P along e_R, e_theta, e_phi."""
    ground = Frame("ground")
    phi = pi(g.beta_1) / 2 - moving(g.beta_1, rate=g.b_dot)
    P = spherical(ground, "P", g.R, moving(0, rate=g.n), phi)
    return phi, P.velocity(ground), P.acceleration(ground)


def solve(g):
    _, v, a = tip(g)
    return {"speed": v.norm(), "acc_mag": a.norm()}


def steps(g):
    phi, v, a = tip(g)
    yield "theta_dot", g.n
    yield "phi", phi.value
    yield "phi_dot", phi.rate
    yield "v", v
    yield from terms(a, "a", "m/s^2", "3.7")
    yield "a", a


def prove(g):
    P = tip_in_time(g)
    phi, v = elevation_in_time(P), rate(P)
    answers = {"speed": size(v), "acc_mag": size(second_rate(P))}
    return answers | {"phi": phi(0), "phi_dot": rate(phi), "v": times(spherical_axes(P(0)), v)}


def mistakes(g):
    _, v, a = tip(g)
    return {
        "beta_as_elevation": solve(g.but(beta_1=pi(g.beta_1) / 2 - g.beta_1)),
        "no_coupling": {"acc_mag": a.without("coriolis_theta_phi").norm()},
        "n_as_rad_per_s": solve(g.but(n=g.stated("n"))),
        "speeds_added": {"speed": v.terms["theta"].norm() + v.terms["phi"].norm()},
    }


def draw(g, ax):
    figure(g, ax, *crane(g))
