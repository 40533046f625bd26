"""4/18: the outer tip A of a bracket on a turning arm."""

from exercises.devices import bracket_on_arm as device
from exercises.tools import in_frame


def tip(g):
    ground, arm, bracket = device.arm_and_bracket(g)
    return ground, arm, bracket.point("A", 0, g.b, g.a)


def solve(g):
    ground, arm, A = tip(g)
    return device.motion_by_way_of_arm(A, ground, arm)


def steps(g):
    ground, arm, A = tip(g)
    return device.motion_steps(A, ground, arm)


def prove(g):
    return device.motion_in_time(g, "A", g.b, g.a)


def mistakes(g):
    ground, arm, A = tip(g)
    return device.common_mistakes(A, ground) | in_frame(ground, {
        # all of alpha is omega_2 x omega_1
        "no_cross_product": {"a_A": A.acceleration(ground).without("euler")},
        "no_coriolis": {"a_A": A.acceleration(ground, via=arm).without("coriolis")},
    })  # fmt: skip


def draw(g, ax):
    s, B, A = device.sketch(g, ax, g.a)
    s.dimension(B, A, label="a")
