"""A/21: triple products of three vectors."""

from exercises.tools import minus, mp, scaled
from newton_euler import Frame

AXES = Frame("axes")
follows = {"c": lambda g, b: -b}


def vectors(g):
    return (
        AXES.vector(g.A_1, g.A_2, g.A_3),
        AXES.vector(g.B_1, g.B_2, g.B_3),
        AXES.vector(g.C_1, g.C_2, g.C_3),
    )


def solve(g):
    A, B, C = vectors(g)
    return {"a": A.cross(B.cross(C)), "b": A.dot(B.cross(C)), "c": B.dot(A.cross(C))}


def steps(g):
    A, B, C = vectors(g)
    return {"u": B.cross(C), "w": A.cross(C)}


def prove(g):
    """(a) as a combination of B and C, (A.16); (b) and (c) as determinants."""
    A, B, C = [g.A_1, g.A_2, g.A_3], [g.B_1, g.B_2, g.B_3], [g.C_1, g.C_2, g.C_3]
    dot = lambda v, w: sum(x * y for x, y in zip(v, w, strict=True))
    volume = lambda *rows: mp.det(mp.matrix(rows))
    a = minus(scaled(dot(A, C), B), scaled(dot(A, B), C))
    return {"a": a, "b": volume(A, B, C), "c": volume(B, A, C)}


def mistakes(g):
    A, B, C = vectors(g)
    return {
        "brackets": {"a": A.cross(B).cross(C)},
        "c_is_b": {"c": A.dot(B.cross(C))},
        "turned_over": {"a": B.cross(C).cross(A)},
    }
