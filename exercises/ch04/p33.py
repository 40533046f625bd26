"""4/33: a bevel gear that rolls round a turning one."""

from exercises.devices import bevel_gears
from exercises.tools import in_frame


def steps(g):
    yield from bevel_gears.steps(g.n, g.n_C, g.tan_gamma, r"(n_C - n) \tan\gamma")


follows = bevel_gears.follows


def solve(g):
    return bevel_gears.answers(g.n, g.n_C, g.tan_gamma)


def prove(g):
    return bevel_gears.proved(g.n, g.n_C, g.tan_gamma)


def mistakes(g):
    _, arm, _ = bevel_gears.gears(g.n, g.n_C, g.tan_gamma)
    wrong = {
        "C_at_rest": solve(g.but(n_C=0)),
        "n_C_added": solve(g.but(n_C=-g.n_C)),
        "arm_at_relative_rate": solve(g.but(n=g.n - g.n_C, n_C=0)),
        "alpha_zero": {"alpha_B": arm.vector(0, 0, 0)},
        "rev_per_min_as_rad_per_s": solve(g.but(n=g.stated("n"), n_C=g.stated("n_C"))),
    }
    return in_frame(arm, wrong)


def draw(g, ax):
    bevel_gears.figure(ax, g.tan_gamma, C_turns=True)
