"""4/33: a bevel gear that rolls round a turning one."""

from exercises.devices.bevel_gears import draw, follows, gears, prove, solve, steps
from exercises.tools import in_frame


def mistakes(g):
    _, arm, _ = gears(g)
    wrong = {
        "C_at_rest": solve(g.but(n_C=0)),
        "n_C_added": solve(g.but(n_C=-g.n_C)),
        "arm_at_relative_rate": solve(g.but(n=g.n - g.n_C, n_C=0)),
        "alpha_zero": {"alpha_B": arm.vector(0, 0, 0)},
        "rev_per_min_as_rad_per_s": solve(g.but(n=g.stated("n"), n_C=g.stated("n_C"))),
    }
    return in_frame(arm, wrong)
