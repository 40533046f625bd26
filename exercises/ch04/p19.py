"""4/19: the corner B of the bracket of 4/18."""

from exercises.devices import bracket_on_arm as device


def solve(g):
    ground, arm, bracket = device.arm_and_bracket(g)
    return device.motion_by_way_of_arm(bracket.point("B", 0, g.b, 0), ground, arm)


def steps(g):
    ground, arm, bracket = device.arm_and_bracket(g)
    return device.motion_steps(bracket.point("B", 0, g.b, 0), ground, arm)


def prove(g):
    return device.motion_in_time(g, "B", g.b, 0)


def mistakes(g):
    ground, arm, bracket = device.arm_and_bracket(g)
    along_arm = bracket.point("B", g.b, 0, 0)
    return device.common_mistakes(bracket.point("B", 0, g.b, 0), ground) | {
        "omega_1_reversed": solve(g.but(omega_1=-g.omega_1)),
        "CB_along_arm": device.motion_by_way_of_arm(along_arm, ground, arm),
    }


def draw(g, ax):
    device.sketch(g, ax, 1.25 * g.b)
