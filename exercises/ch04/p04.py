"""4/4: a crane that revolves while its boom is lowered."""

from exercises.devices.boom import acceleration_without_cross_product
from exercises.devices.crane import crane, figure, tip_in_time
from exercises.proofs import rate, second_rate, size
from newton_euler import pi


def solve(g):
    ground, house, P = crane(g)
    return {
        "speed": P.velocity(ground, via=house).norm(),
        "acc_mag": P.acceleration(ground, via=house).norm(),
    }


def prove(g):
    P = tip_in_time(g)
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
    frames = ground, house, _ = crane(g)
    figure(g, ax, *frames).axes(ground.origin, house, length=0.25 * g.R)
