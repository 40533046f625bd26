"""4/19: the corner B of the bracket of 4/18."""

from exercises.devices import bracket_on_arm as device

corner, solve, steps, prove = device.problem_of("B", lambda g: 0)


def mistakes(g):
    B, ground, arm = corner(g)
    return device.common_mistakes(B, ground) | {
        "omega_1_reversed": solve(g.but(omega_1=-g.omega_1)),
        "CB_along_arm": device.motion_by_way_of_arm(B.frame.point("B", g.b, 0, 0), ground, arm),
    }


def draw(g, ax):
    device.sketch(g, ax, 1.25 * g.b)
