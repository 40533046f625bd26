"""2/36: an end of a rod that slides in a turning bracket."""

from exercises.devices import sliding_rod
from exercises.devices.turning_plate import acceleration_from, motion, motion_steps


def end(g):
    return sliding_rod.end(g, "B", -g.x_B, g.y_B)


def solve(g):
    return motion(*end(g))


def steps(g):
    yield from motion_steps(*end(g), "mm")


follows = {"a_B": lambda g, v_B: acceleration_from(*end(g), v_B)}


def prove(g):
    return sliding_rod.prove(g, "B", -g.x_B, g.y_B)


def mistakes(g):
    return sliding_rod.common_mistakes(g, end, "x_B")


def draw(g, ax):
    sliding_rod.draw(g, ax, "B", -g.x_B, g.y_B)
