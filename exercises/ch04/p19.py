"""4/19: the corner B of the bracket of 4/18."""

from exercises.devices.bracket_on_arm import (
    arm_and_bracket,
    common_mistakes,
    motion_by_way_of_arm,
    motion_in_time,
    motion_steps,
    sketch,
)


def solve(g):
    ground, arm, bracket = arm_and_bracket(g)
    return motion_by_way_of_arm(bracket.point("B", 0, g.b, 0), ground, arm)


def steps(g):
    ground, arm, bracket = arm_and_bracket(g)
    return motion_steps(bracket.point("B", 0, g.b, 0), ground, arm)


def prove(g):
    return motion_in_time(g, "B", g.b, 0)


def mistakes(g):
    ground, arm, bracket = arm_and_bracket(g)
    along_arm = bracket.point("B", g.b, 0, 0)
    return common_mistakes(bracket.point("B", 0, g.b, 0), ground) | {
        "omega_1_reversed": solve(g.but(omega_1=-g.omega_1)),
        "CB_along_arm": motion_by_way_of_arm(along_arm, ground, arm),
    }


def draw(g, ax):
    sketch(g, ax, 1.25 * g.b)
