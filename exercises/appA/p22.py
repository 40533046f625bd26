"""A/22: the dot product of two cross products, by any four vectors with these dot products."""

from exercises.tools import cross, mp
from newton_euler import Frame


def vectors(g):
    """Four vectors with the dot products AC, BD, AD, BC, not coplanar."""
    axes = Frame("axes")
    i, j, k = (v * g.one for v in (axes.i, axes.j, axes.k))
    return i, j, g.AC * i + g.BC * j + k, g.AD * i + g.BD * j - 2 * k


def solve(g):
    A, B, C, D = vectors(g)
    return {"product": A.cross(B).dot(C.cross(D))}


def steps(g):
    return {"on_C": g.BD, "on_D": -g.BC}


def prove(g):
    """By other vectors: A and B oblique, C and D with a component normal to their plane."""
    A, B = [1, 2, 2], [3, -1, 1]
    N = cross(A, B)

    def with_products(to_A, to_B, across):
        return list(mp.lu_solve(mp.matrix([A, B, N]), mp.matrix([to_A, to_B, across])))

    C, D = with_products(g.AC, g.BC, 5), with_products(g.AD, g.BD, -7)
    return {"product": mp.det(mp.matrix([A, B, cross(C, D)]))}


def mistakes(g):
    first, second = g.AC * g.BD, g.AD * g.BC
    return {
        "sign": {"product": second - first},
        "sum": {"product": first + second},
        "first_only": {"product": first},
    }
