"""A/14: the magnitude of the difference of two vectors."""

from exercises.tools import Sketch, cross, mp, size
from newton_euler import Frame

AXES = Frame("axes")


def vectors(g):
    return AXES.vector(g.a_1, g.a_2, g.a_3), AXES.vector(g.b_1, g.b_2, g.b_3)


def solve(g):
    A, B = vectors(g)
    return {"mag": (B - A).norm()}


def steps(g):
    A, B = vectors(g)
    return {"G": B - A}


def prove(g):
    """The third side of the triangle with the sides A and B, from the angle between them."""
    A, B = [g.a_1, g.a_2, g.a_3], [g.b_1, g.b_2, g.b_3]
    along = sum(x * y for x, y in zip(A, B, strict=True)) / size(A)
    angle = mp.atan2(size(cross(A, B)) / size(A), along)
    return {"mag": mp.sqrt(size(A) ** 2 + size(B) ** 2 - 2 * size(A) * size(B) * mp.cos(angle))}


def mistakes(g):
    A, B = vectors(g)
    return {
        "of_magnitudes": {"mag": B.norm() - A.norm()},
        "no_root": {"mag": (B - A).dot(B - A)},
        "of_sum": {"mag": (A + B).norm()},
    }


def draw(g, ax):
    A, B = vectors(g)
    s = Sketch(ax, AXES, azimuth=35, elevation=22)
    O, a, b = (0, 0, 0), A.components(), B.components()
    s.axes(O, AXES, length=1, labels=["i", "j", "k"])
    s.arrow(O, a)
    s.arrow(O, b)
    s.arrow(a, b, "G")
    s.label(a, "A")
    s.label(b, "B")
