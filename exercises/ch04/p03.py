"""4/3: the two perpendicular arms of a robot on a turning base."""

from exercises.devices.boom import acceleration_without_cross_product
from exercises.devices.moving_frame import seen_in, turning_of
from exercises.devices.robot_arm import figure, robot, tip_in_time
from exercises.tools import in_frame, rate, rot, second_rate, size, terms, times

follows = {"acc_mag": lambda g, a: a.norm()}


def with_size(a):
    return {"a": a, "acc_mag": a.norm()}


def solve(g):
    ground, base, P = robot(g)
    return in_frame(ground, with_size(P.acceleration(ground, via=base)))


def steps(g):
    ground, base, P = robot(g)
    yield from turning_of(base, ground, ground, "base", "the moving frame, fixed in the base,")
    yield from seen_in(base, P, ground, "m", "the base", "O")
    yield from terms(solve(g)["a"], "a", "m/s^2", "4.8")


def prove(g):
    P = tip_in_time(g)
    seen = lambda t: times(rot("z", -g.omega * t), P(t))
    a = second_rate(P)
    return {"a": a, "acc_mag": size(a), "v_r": rate(seen), "a_r": second_rate(seen)}


def mistakes(g):
    ground, base, P = robot(g)
    in_degrees = {n: g.stated(n) for n in ("omega", "b_dot", "b_ddot")}
    wrong = {
        "rates_in_degrees": solve(g.but(**in_degrees)),
        "no_coriolis": with_size(P.acceleration(ground, via=base).without("coriolis")),
        "no_tangential": solve(g.but(b_ddot=0)),
        "beta_the_other_way": solve(g.but(b_dot=-g.b_dot, b_ddot=-g.b_ddot)),
        "no_cross_product": with_size(acceleration_without_cross_product(P, ground)),
    }
    return in_frame(ground, wrong)


def draw(g, ax):
    frames = ground, base, _ = robot(g)
    figure(g, ax, *frames).axes(ground.origin, base, labels="xyz")
