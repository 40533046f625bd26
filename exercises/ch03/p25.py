"""3/25: two perpendicular arms of a robot on a turning base, in spherical components about O."""

from exercises.devices.robot_arm import figure, robot, tip_in_time
from exercises.devices.spherical_point import elevation_in_time, local_acceleration
from exercises.tools import mp, rate, second_rate, size, terms
from newton_euler import Frame, atan2, moving, pi, spherical, sqrt

follows = {"acc_mag": lambda g, a: a.norm()}


def angle_AOP(g):
    """The angle at O in the right triangle OAP."""
    return atan2(g.l_AP, g.l_OA)


def tip(g, inside):
    """Ground, and P as the end of OP, at the angle ``inside`` below OA."""
    ground = Frame("ground")
    phi = pi(g.beta_1) / 2 - moving(g.beta_1, g.b_dot, g.b_ddot) - inside
    R = sqrt(g.l_OA**2 + g.l_AP**2)
    return ground, spherical(ground, "P", R, moving(0, rate=g.omega), phi)


def with_size(a):
    return {"a": a, "acc_mag": a.norm()}


def answers(g, inside):
    ground, P = tip(g, inside)
    return with_size(P.acceleration(ground))


def solve(g):
    return answers(g, angle_AOP(g))


def steps(g):
    ground, P = tip(g, angle_AOP(g))
    R, _, phi = P.coordinates
    yield "R", R.value
    yield "AOP", angle_AOP(g)
    yield "phi", phi.value
    yield "phi_dot", phi.rate
    yield "phi_ddot", phi.acceleration
    yield from terms(P.acceleration(ground), "a", "m/s^2", "3.7")


def prove(g):
    """By the rectangular coordinates of P over time."""
    P = tip_in_time(g)
    a, phi = local_acceleration(P), elevation_in_time(P)
    return {
        "a": a,
        "acc_mag": size(a),
        "R": size(P(0)),
        "AOP": mp.acos(g.l_OA / size(P(0))),
        "phi": phi(0),
        "phi_dot": rate(phi),
        "phi_ddot": second_rate(phi),
    }


def mistakes(g):
    in_degrees = {n: g.stated(n) for n in ("omega", "b_dot", "b_ddot")}
    return {
        "rates_in_degrees": solve(g.but(**in_degrees)),
        "elevation_of_OA": answers(g, 0),
        "beta_raises": solve(g.but(b_dot=-g.b_dot, b_ddot=-g.b_ddot)),
        "no_coupling": with_size(solve(g)["a"].without("coriolis_theta_phi")),
    }


def draw(g, ax):
    ground, base, P = robot(g)
    figure(g, ax, ground, base, P).line(ground.origin, P)
