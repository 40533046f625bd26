"""4/4: a crane that revolves while its boom is lowered."""

from mpmath import mp

from exercises.devices.boom import acceleration_without_cross_product, turning_boom
from exercises.proofs import rate, rot, second_rate, size, times
from newton_euler import moving, pi
from newton_euler.drawing import Sketch


def crane(g):
    ground, house, boom = turning_boom(g.n, moving(g.beta_1, g.b_dot))
    return ground, house, boom.point("P", 0, 0, g.R)


def solve(g):
    ground, house, P = crane(g)
    return {"speed": P.velocity(ground, via=house).norm(), "acc_mag": P.acceleration(ground, via=house).norm()}


def prove(g):
    def P(t):
        beta = g.beta_1 + g.b_dot * t
        return times(rot("z", g.n * t), [g.R * mp.sin(beta), 0, g.R * mp.cos(beta)])

    return {"speed": size(rate(P)), "acc_mag": size(second_rate(P))}


def mistakes(g):
    ground, house, P = crane(g)
    v = P.velocity(ground, via=house).terms
    return {
        "no_coriolis": {"acc_mag": P.acceleration(ground, via=house).without("coriolis").norm()},
        "beta_as_elevation": solve(g.but(beta_1=pi(g.beta_1) / 2 - g.beta_1)),
        "no_cross_product": {"acc_mag": acceleration_without_cross_product(P, ground).norm()},
        "n_as_rad_per_s": solve(g.but(n=g.stated("n"))),
        "speeds_added": {"speed": v["relative"].norm() + v["rotation"].norm()},
    }


def draw(g, ax):
    ground, house, P = crane(g)
    O, up, foot = ground.point("O", 0, 0, 0), (0, 0, 0.6 * g.R), (0, 0, -0.3 * g.R)
    s = Sketch(ax, ground, azimuth=-110, elevation=15)
    s.ground(foot, normal=ground.k, size=0.8 * g.R)
    s.cylinder(foot, (0, 0, -0.22 * g.R), 0.2 * g.R)
    s.box((-0.07 * g.R, 0, -0.11 * g.R), house, (0.34 * g.R, 0.22 * g.R, 0.22 * g.R))
    s.rod(O, P)
    s.hinge(O, house.j)
    s.line(O, up)
    s.arc(O, up, P, label=r"$\beta$")
    s.turn((0, 0, 0.5 * g.R), ground.k, label="n")
    s.vector(P, P.velocity(house), r"$\dot\beta$", kind="rate")
    s.axes(O, house, length=0.25 * g.R)
    s.dimension(O, P, label="R", offset=-0.08 * g.R)
    s.label(O, "O")
    s.label(P, "P")
