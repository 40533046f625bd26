"""2/34: the lower tip of a bracket that slides on a turning plate."""

from exercises.devices import welder
from exercises.devices.turning_plate import acceleration_from, motion, motion_steps, proof


def tip(g):
    return welder.tip(g, "E", g.x_E, -g.y_E)


def solve(g):
    return motion(*tip(g))


def steps(g):
    yield from motion_steps(*tip(g), "in")


follows = {"a_E": lambda g, v_E: acceleration_from(*tip(g), v_E)}


def prove(g):
    return proof("E", "plate", lambda t: g.omega * t, lambda t: g.x_E + g.u * t, lambda t: -g.y_E)


def mistakes(g):
    return welder.mistakes(g, "E", g.x_E, -g.y_E)


def draw(g, ax):
    welder.draw(g, ax, "E", g.x_E, -g.y_E)
