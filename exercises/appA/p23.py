"""A/23: the derivatives of a dot and a cross product, with numbers that vary besides the symbol."""

from exercises.tools import mp, rate
from newton_euler import Frame, moving

AXES = Frame("axes")


def vectors(g):
    """A and B; t runs at the rate 1."""
    t = moving(g.t, rate=g.one)
    return AXES.vector(g.c_1 * t**2, g.c_2 * t, g.c_3), AXES.vector(g.b_1, g.b_2, 0)


def solve(g):
    """B is constant, a factor of the derivative of the dot product."""
    A, B = vectors(g)
    return {"rate_BA": B.dot(A.rate(AXES)), "rate_BxA": B.cross(A).rate(AXES)}


def steps(g):
    return {"A_dot": vectors(g)[0].rate(AXES)}


def prove(g):
    """Both products multiplied out, and differences of them."""

    def dot(s):
        t = g.t + s
        return g.b_1 * g.c_1 * t**2 + g.b_2 * g.c_2 * t

    def cross(s):
        t = g.t + s
        A, B = [g.c_1 * t**2, g.c_2 * t, g.c_3], [g.b_1, g.b_2, 0]
        unit = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        return [mp.det(mp.matrix([e, B, A])) for e in unit]

    return {"rate_BA": rate(dot), "rate_BxA": rate(cross)}


def mistakes(g):
    A, B = vectors(g)
    right = solve(g)
    kept = A.rate(AXES) + g.c_3 * AXES.k
    return {
        "AxB": {"rate_BxA": A.cross(B).rate(AXES)},
        "product_of_derivatives": {key: 0 * x for key, x in right.items()},
        "keeps_constant": {"rate_BxA": B.cross(kept)},
    }
