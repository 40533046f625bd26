"""4/32: a bevel gear that rolls round a fixed one."""

from exercises.devices import bevel_gears
from exercises.tools import in_frame


def steps(g):
    return bevel_gears.steps(g.n, 0, g.tan_gamma, r"-n \tan\gamma")


follows = bevel_gears.follows


def solve(g):
    return bevel_gears.answers(g.n, 0, g.tan_gamma)


def prove(g):
    return bevel_gears.proved(g.n, 0, g.tan_gamma)


def mistakes(g):
    ground, arm, B = bevel_gears.gears(g.n, 0, g.tan_gamma)
    wrong = {
        "only_spin": {"omega_B": B.angular_velocity(ground).without("OA")},
        "alpha_zero": {"alpha_B": arm.vector(0, 0, 0)},
        "inverse_ratio": solve(g.but(tan_gamma=1 / g.tan_gamma)),
        "wrong_sense": solve(g.but(tan_gamma=-g.tan_gamma)),
        "rev_per_min_as_rad_per_s": solve(g.but(n=g.stated("n"))),
    }
    return in_frame(arm, wrong)


def draw(g, ax):
    bevel_gears.figure(ax, g.tan_gamma, C_turns=False)
