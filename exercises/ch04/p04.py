"""4/4: a crane that revolves while its boom is lowered."""

from exercises.devices.boom import acceleration_without_cross_product
from exercises.devices.crane import crane, figure, tip_in_time
from exercises.devices.moving_frame import motion_via
from exercises.tools import rate, rot, second_rate, size, times
from newton_euler import pi


def solve(g):
    ground, house, P = crane(g)
    v, a = P.velocity(ground, via=house), P.acceleration(ground, via=house)
    return {"speed": v.norm(), "acc_mag": a.norm()}


def steps(g):
    ground, house, P = crane(g)
    start = "O, with x outward in the plane of the boom and z up"
    return motion_via(house, P, ground, "house", "the crane house", start)


def prove(g):
    P = tip_in_time(g)
    seen = lambda t: times(rot("z", -g.n * t), P(t))
    v, a = rate(P), second_rate(P)
    found = {"v_P": v, "a_P": a, "v_r": rate(seen), "a_r": second_rate(seen)}
    return {"speed": size(v), "acc_mag": size(a)} | found


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
