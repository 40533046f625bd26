"""A/7: double cross products of unit vectors, without numbers: g.one is the number 1."""

from exercises.tools import Sketch, cross
from newton_euler import Frame


def triad(g):
    """i, j, k, with components of the type of ``g.one``."""
    axes = Frame("axes")
    return axes.i * g.one, axes.j * g.one, axes.k * g.one


def solve(g):
    i, j, _ = triad(g)
    return {"iij": i.cross(i.cross(j)), "ii_j": i.cross(i).cross(j)}


def steps(g):
    i, j, _ = triad(g)
    return {"u": i.cross(j), "w": i.cross(i)}


def prove(g):
    i, j = [g.one, 0, 0], [0, g.one, 0]
    return {"iij": cross(i, cross(i, j)), "ii_j": cross(cross(i, i), j)}


def mistakes(g):
    _, j, _ = triad(g)
    return {"k_to_plus_j": {"iij": j}, "associative": {"iij": 0 * j}, "i_x_i_is_one": {"ii_j": j}}


def draw(g, ax):
    axes = Frame("axes")
    s = Sketch(ax, axes, azimuth=35, elevation=22)
    s.axes((0, 0, 0), axes, length=1, labels=["i", "j", "k"])
