"""2/37: the rod of 2/36 in a bracket that speeds up."""

from exercises.devices import sliding_rod
from exercises.devices.turning_plate import acceleration_from, motion

end, solve, steps, prove, draw = sliding_rod.about("B", -1)
follows = {"a_B": lambda g, v_B: acceleration_from(*end(g), v_B)}


def mistakes(g):
    return {
        "alpha_counterclockwise": {"a_B": motion(*end(g.but(alpha=-g.alpha)))["a_B"]},
        "no_alpha": sliding_rod.without(*end(g), "euler"),
        "no_coriolis": sliding_rod.without(*end(g), "coriolis"),
        "both_counterclockwise": motion(*end(g.but(omega=-g.omega, alpha=-g.alpha))),
    }
