"""2/39: the other end of the rod of 2/36."""

from exercises.devices import sliding_rod
from exercises.devices.turning_plate import acceleration_from, motion, motion_steps


def end(g):
    return sliding_rod.end(g, "E", g.x_E, g.y_E)


def solve(g):
    return motion(*end(g))


def steps(g):
    yield from motion_steps(*end(g), "mm")


follows = {"a_E": lambda g, v_E: acceleration_from(*end(g), v_E)}


def prove(g):
    return sliding_rod.prove(g, "E", g.x_E, g.y_E)


def mistakes(g):
    return sliding_rod.common_mistakes(g, end, "x_E")


def draw(g, ax):
    sliding_rod.draw(g, ax, "E", g.x_E, g.y_E)
