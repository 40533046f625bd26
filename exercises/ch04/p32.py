"""4/32: a bevel gear that rolls round a fixed one."""

from exercises.devices.bevel_gears import draw, follows, gears, prove, solve, steps
from exercises.tools import in_frame


def mistakes(g):
    ground, arm, B = gears(g)
    wrong = {
        "only_spin": {"omega_B": B.angular_velocity(ground).without("OA")},
        "alpha_zero": {"alpha_B": arm.vector(0, 0, 0)},
        "inverse_ratio": solve(g.but(tan_gamma=1 / g.tan_gamma)),
        "wrong_sense": solve(g.but(tan_gamma=-g.tan_gamma)),
        "rev_per_min_as_rad_per_s": solve(g.but(n=g.stated("n"))),
    }
    return in_frame(arm, wrong)
