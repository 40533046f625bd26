"""2/37: the rod of 2/36 in a bracket that speeds up."""

from exercises.devices import sliding_rod
from exercises.devices.turning_plate import acceleration_from, motion, motion_steps


def end(g):
    return sliding_rod.end(g, "B", -g.x_B, g.y_B, alpha=g.alpha)


def solve(g):
    return motion(*end(g))


def steps(g):
    yield from motion_steps(*end(g), "mm")


follows = {"a_B": lambda g, v_B: acceleration_from(*end(g), v_B)}


def prove(g):
    return sliding_rod.prove(g, "B", -g.x_B, g.y_B, alpha=g.alpha)


def mistakes(g):
    against = motion(*end(g.but(alpha=-g.alpha)))
    return {
        "alpha_counterclockwise": {"a_B": against["a_B"]},
        "no_alpha": sliding_rod.without(*end(g), "euler"),
        "no_coriolis": sliding_rod.without(*end(g), "coriolis"),
        "both_counterclockwise": motion(*end(g.but(omega=-g.omega, alpha=-g.alpha))),
    }


def draw(g, ax):
    sliding_rod.draw(g, ax, "B", -g.x_B, g.y_B)
