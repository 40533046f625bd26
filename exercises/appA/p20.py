"""A/20: double cross products as combinations of factors, by vectors with these dot products."""

from exercises.tools import plus
from newton_euler import Frame, solve_linear

COEFFICIENTS = Frame("A, B, C")


def double(g, PQ, PR, QR):
    """The coefficients of Q and R in P x (Q x R), from the dot products: it lies in their plane."""
    axes = Frame("axes")
    Q, R = axes.i * g.one, axes.vector(QR, 1, 0)
    v = axes.vector(PQ, PR - PQ * QR, 1).cross(Q.cross(R))
    found = solve_linear(lambda q, r: q * Q + r * R - v)
    return found.q, found.r


def solve(g):
    first = double(g, g.AB, g.CA, g.BC)
    second = double(g, g.BC, g.AB, g.CA)
    third = double(g, g.CA, g.BC, g.AB)
    three = {
        "first": COEFFICIENTS.vector(0, *first),
        "second": COEFFICIENTS.vector(second[1], 0, second[0]),
        "third": COEFFICIENTS.vector(*third, 0),
    }
    return three | {"total": total(g, **three)}


def total(g, first, second, third):
    return first + second + third


follows = {"total": total}


def prove(g):
    """By the rule of the book for (P x Q) x R, the brackets exchanged."""
    dot = {"AB": g.AB, "BA": g.AB, "BC": g.BC, "CB": g.BC, "CA": g.CA, "AC": g.CA}

    def double(P, Q, R):
        """P x (Q x R) = -(Q x R) x P = (P.R) Q - (P.Q) R."""
        return [{Q: dot[P + R], R: -dot[P + Q]}.get(name, 0) for name in "ABC"]

    three = double("A", "B", "C"), double("B", "C", "A"), double("C", "A", "B")
    found = dict(zip(("first", "second", "third"), three, strict=True))
    return found | {"total": plus(*three)}


def mistakes(g):
    """(A x B) x C is minus C x (A x B)."""
    right = solve(g)
    first, second, third = right["first"], right["second"], right["third"]
    return {
        "brackets": {"first": -third, "second": -first, "third": -second},
        "signs": {"first": -first, "second": -second, "third": -third},
    }
