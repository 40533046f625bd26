"""A/1: position vectors of two points, and of one with respect to the other."""

from exercises.tools import Sketch, plus, rate, scaled
from newton_euler import Frame

AXES = Frame("axes")
follows = {"r_BA": lambda g, r_A, r_B: r_B - r_A}


def points(g):
    return AXES.point("A", g.A_x, g.A_y, g.A_z), AXES.point("B", g.B_x, g.B_y, g.B_z)


def solve(g):
    A, B = points(g)
    return {"r_A": A.position(AXES), "r_B": B.position(AXES), "r_BA": B - A}


def prove(g):
    """By a point that moves uniformly from A to B in unit time."""
    A, B = [g.A_x, g.A_y, g.A_z], [g.B_x, g.B_y, g.B_z]
    place = lambda t: plus(scaled(1 - t, A), scaled(t, B))
    return {"r_A": place(0), "r_B": place(1), "r_BA": rate(place)}


def mistakes(g):
    right = solve(g)
    return {"A_from_B": {"r_BA": -right["r_BA"]}, "sum": {"r_BA": right["r_A"] + right["r_B"]}}


def draw(g, ax):
    A, B = points(g)
    s = Sketch(ax, AXES, azimuth=70, elevation=22)
    O = AXES.origin
    s.axes(O, AXES, length=3, labels=["i", "j", "k"])
    for P in (A, B):
        x, y, _ = P.position(AXES).components()
        s.arrow(O, P)
        s.line(P, (x, y, 0), style="dotted")
        s.line(O, (x, y, 0), style="dotted")
        s.label(P, P.name)
    s.line(A, B)
    s.label(O, "O", offset=(12, 8))
