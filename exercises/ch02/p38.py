"""2/38: the rod of 2/36, which slows down in the bracket."""

from exercises.devices import sliding_rod
from exercises.devices.turning_plate import acceleration_from, motion, motion_steps


def end(g):
    return sliding_rod.end(g, "B", -g.x_B, g.y_B, a_r=-g.dec)


def solve(g):
    return motion(*end(g))


def steps(g):
    yield from motion_steps(*end(g), "mm")


follows = {"a_B": lambda g, v_B: acceleration_from(*end(g), v_B)}


def prove(g):
    return sliding_rod.prove(g, "B", -g.x_B, g.y_B, a_r=-g.dec)


def mistakes(g):
    return {
        "a_rel_forward": {"a_B": motion(*end(g.but(dec=-g.dec)))["a_B"]},
        "no_coriolis": sliding_rod.without(*end(g), "coriolis"),
        "no_centripetal": sliding_rod.without(*end(g), "centripetal"),
        "no_a_rel": sliding_rod.without(*end(g), "relative"),
    }


def draw(g, ax):
    sliding_rod.draw(g, ax, "B", -g.x_B, g.y_B)
