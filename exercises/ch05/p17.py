"""5/17: the weight at an altitude."""

from exercises.devices.planet import pull
from exercises.tools import Sketch
from newton_euler import Frame
from newton_euler.dynamics import gravity_at_height


def solve(g):
    # weight and acceleration of gravity fall alike
    return {"W": gravity_at_height(g.h, g.R_e, g=g.W0)}


def steps(g):
    return {"r": g.R_e + g.h, "fall": (g.R_e / (g.R_e + g.h)) ** 2}


def prove(g):
    share = pull(1, g.R_e, g.R_e + g.h) / pull(1, g.R_e, g.R_e)
    return {"W": g.W0 * share, "fall": share}


def mistakes(g):
    return {
        "first_power": {"W": g.W0 * g.R_e / (g.R_e + g.h)},
        "altitude_for_distance": {"W": gravity_at_height(g.h - g.R_e, g.R_e, g=g.W0)},
        "flat_earth": {"W": g.W0},
    }


def draw(g, ax):
    ground = Frame("earth")
    s = Sketch(ax, ground, plane="xz")
    O, side, top, P = (0, 0, 0), (g.R_e, 0, 0), (0, 0, g.R_e), (0, 0, g.R_e + g.h)
    s.disk(O, ground.j, g.R_e)
    s.line(O, P)
    s.line(O, side, style="solid")
    s.dot(O)
    s.dot(P)
    s.vector(P, -ground.k, "W", kind="force")
    s.dimension(top, P, label="h", offset=0.25 * g.R_e)
    s.dimension(O, side, label="$R_e$", offset=-0.12 * g.R_e)
