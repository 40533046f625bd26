"""A/10: the product rules, by moving components that the engine multiplies and differentiates."""

from exercises.tools import mp, rate
from newton_euler import Frame, moving

AXES = Frame("axes")


def vectors(g):
    return AXES.vector(g.a_1, g.a_2, g.a_3), AXES.vector(g.b_1, g.b_2, g.b_3)


def rates(g):
    A = AXES.vector(g.a_1_dot, g.a_2_dot, g.a_3_dot)
    return A, AXES.vector(g.b_1_dot, g.b_2_dot, g.b_3_dot)


def solve(g):
    moved = lambda v, dv: [moving(x, rate=slope) for x, slope in zip(v, dv, strict=True)]
    a, b = map(moved, vectors(g), rates(g))
    u = moving(g.u, rate=g.u_dot)
    A, B, uA = AXES.vector(*a), AXES.vector(*b), AXES.vector(*(u * x for x in a))
    return {
        "rate_sum": (A + B).rate(AXES),
        "rate_uA": uA.rate(AXES),
        "rate_AB": sum(x * y for x, y in zip(a, b, strict=True)).rate,
        "rate_AxB": A.cross(B).rate(AXES),
    }


def steps(g):
    A, B = vectors(g)
    dA, dB = rates(g)
    return {"from_u": g.u_dot * A, "from_A": g.u * dA, "p_A": dA.cross(B), "p_B": A.cross(dB)}


def prove(g):
    """Differences over a short time; the dot product from lengths, the cross by determinants."""
    A = lambda t: [g.a_1 + g.a_1_dot * t, g.a_2 + g.a_2_dot * t, g.a_3 + g.a_3_dot * t]
    B = lambda t: [g.b_1 + g.b_1_dot * t, g.b_2 + g.b_2_dot * t, g.b_3 + g.b_3_dot * t]
    square = lambda t, sign: sum((x + sign * y) ** 2 for x, y in zip(A(t), B(t), strict=True))

    def volumes(t):
        unit = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        return [mp.det(mp.matrix([e, A(t), B(t)])) for e in unit]

    return {
        "rate_sum": rate(lambda t: [x + y for x, y in zip(A(t), B(t), strict=True)]),
        "rate_uA": rate(lambda t: [(g.u + g.u_dot * t) * x for x in A(t)]),
        "rate_AB": rate(lambda t: (square(t, 1) - square(t, -1)) / 4),
        "rate_AxB": rate(volumes),
    }


def mistakes(g):
    A, B = vectors(g)
    dA, dB = rates(g)
    products = lambda v, w: {"rate_AB": v.dot(w), "rate_AxB": v.cross(w)}
    return {
        "product_of_derivatives": products(dA, dB) | {"rate_uA": g.u_dot * dA},
        "order": {"rate_AxB": dA.cross(B) + dB.cross(A)},
        "first_factor_only": products(dA, B) | {"rate_uA": g.u_dot * A},
    }
