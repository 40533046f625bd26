"""A/6: the components of a cross product, without numbers and figure."""

from exercises.tools import mp
from newton_euler import Frame

AXES = Frame("axes")


def vectors(g):
    return AXES.vector(g.a_1, g.a_2, g.a_3), AXES.vector(g.b_1, g.b_2, g.b_3)


def solve(g):
    A, B = vectors(g)
    return {"AxB": A.cross(B)}


def steps(g):
    A, B = vectors(g)
    axes = {"i": AXES.i, "j": AXES.j, "k": AXES.k}
    return {f"from_{name}": (a * e).cross(B) for a, (name, e) in zip(A, axes.items(), strict=True)}


def prove(g):
    """Each component as the volume of the box spanned by A, B and a unit vector."""
    volume = lambda *e: mp.det(mp.matrix([e, (g.a_1, g.a_2, g.a_3), (g.b_1, g.b_2, g.b_3)]))
    return {"AxB": [volume(1, 0, 0), volume(0, 1, 0), volume(0, 0, 1)]}


def mistakes(g):
    A, B = vectors(g)
    x, y, z = A.cross(B).components()
    return {"middle_sign": {"AxB": AXES.vector(x, -y, z)}, "B_x_A": {"AxB": B.cross(A)}}
