"""2/35: the upper tip of a bracket that slides on a turning plate."""

from exercises.devices import welder
from exercises.devices.turning_plate import acceleration_from, motion, motion_steps, proof


def tip(g):
    return welder.tip(g, "D", g.x_D, g.y_D)


def solve(g):
    return motion(*tip(g))


def steps(g):
    yield from motion_steps(*tip(g), "in")


follows = {"a_D": lambda g, v_D: acceleration_from(*tip(g), v_D)}


def prove(g):
    return proof("D", "plate", lambda t: g.omega * t, lambda t: g.x_D + g.u * t, lambda t: g.y_D)


def mistakes(g):
    return welder.mistakes(g, "D", g.x_D, g.y_D)


def draw(g, ax):
    welder.draw(g, ax, "D", g.x_D, g.y_D)
