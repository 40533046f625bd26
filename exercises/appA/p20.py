"""A/20: double cross products as combinations of their factors, from dot products."""

from exercises.tools import cross, plus
from newton_euler import Frame

COEFFICIENTS = Frame("A, B, C")
follows = {"total": lambda g, first, second, third: first + second + third}


def double(PQ, PR):
    """The coefficients of Q and R in P x (Q x R) = (P.R) Q - (P.Q) R."""
    return PR, -PQ


def solve(g):
    first, second, third = double(g.AB, g.CA), double(g.BC, g.AB), double(g.CA, g.BC)
    three = {
        "first": COEFFICIENTS.vector(0, *first),
        "second": COEFFICIENTS.vector(second[1], 0, second[0]),
        "third": COEFFICIENTS.vector(*third, 0),
    }
    return three | {"total": follows["total"](g, **three)}


def steps(g):
    return {"on_B": double(g.AB, g.CA)[0]}


def prove(g):
    """By vectors with these dot products: P x (Q x R) is in the plane of Q and R."""

    def double(PQ, PR, QR):
        Q, R = [1, 0, 0], [QR, 1, 0]
        x, y, _ = cross([PQ, PR - PQ * QR, 1], cross(Q, R))
        return x - QR * y, y

    first, second = double(g.AB, g.CA, g.BC), double(g.BC, g.AB, g.CA)
    three = [0, *first], [second[1], 0, second[0]], [*double(g.CA, g.BC, g.AB), 0]
    return {"first": three[0], "second": three[1], "third": three[2], "total": plus(*three)}


def mistakes(g):
    """(A x B) x C is minus C x (A x B)."""
    right = solve(g)
    first, second, third = right["first"], right["second"], right["third"]
    return {
        "brackets": {"first": -third, "second": -first, "third": -second},
        "signs": {"first": -first, "second": -second, "third": -third},
    }
