"""A/27: the equation of a plane from its normal."""

from exercises.tools import Sketch, mp
from newton_euler import Frame

AXES = Frame("axes")


def normal(g):
    return AXES.vector(g.N_x, g.N_y, g.N_z)


def place(g):
    return AXES.point("P", g.x, g.y, g.z).position(AXES)


def solve(g):
    return {"F": normal(g).dot(place(g))}


def prove(g):
    """By the volume of the box of r and two vectors in the plane, with the base N_x N."""
    u, v = (-g.N_y, g.N_x, 0), (-g.N_z, 0, g.N_x)
    F = lambda *place: mp.det(mp.matrix([place, u, v])) / g.N_x
    return {"F": F(g.x, g.y, g.z)}


def mistakes(g):
    N, r = normal(g), place(g)
    return {
        "through_the_tip": {"F": N.dot(r - N)},
        "intercepts": {"F": g.x / g.N_x + g.y / g.N_y + g.z / g.N_z},
        "y_sign": solve(g.but(N_y=-g.N_y)),
    }


def draw(g, ax):
    N = normal(g)
    s = Sketch(ax, AXES, azimuth=15, elevation=22)
    O = (0, 0, 0)
    u = 0.6 * N.norm() * AXES.k.cross(N).direction()
    v = 0.6 * N.norm() * N.cross(u).direction()
    s.path([w.components() for w in (u + v, v - u, -u - v, u - v, u + v)])  # hides no axis
    s.line((-u).components(), u.components(), style="dotted")
    s.line((-v).components(), v.components(), style="dotted")
    s.axes(O, AXES, length=0.9 * N.norm())
    s.arrow(O, N.components())
    s.label(N.components(), "N")
    s.label(O, "O")
