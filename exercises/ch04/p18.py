"""4/18: the outer tip A of a bracket on a turning arm."""

from exercises.devices.bracket_on_arm import (
    arm_and_bracket,
    common_mistakes,
    motion_by_way_of_arm,
    motion_in_time,
    motion_steps,
    sketch,
)
from exercises.tools import in_frame


def tip(g):
    ground, arm, bracket = arm_and_bracket(g)
    return ground, arm, bracket.point("A", 0, g.b, g.a)


def solve(g):
    ground, arm, A = tip(g)
    return motion_by_way_of_arm(A, ground, arm)


def steps(g):
    ground, arm, A = tip(g)
    return motion_steps(A, ground, arm)


def prove(g):
    return motion_in_time(g, "A", g.b, g.a)


def mistakes(g):
    ground, arm, A = tip(g)
    return common_mistakes(A, ground) | in_frame(ground, {
        # all of alpha is omega_2 x omega_1
        "no_cross_product": {"a_A": A.acceleration(ground).without("euler")},
        "no_coriolis": {"a_A": A.acceleration(ground, via=arm).without("coriolis")},
    })  # fmt: skip


def draw(g, ax):
    s, B, A = sketch(g, ax, g.a)
    s.dimension(B, A, label="a")
