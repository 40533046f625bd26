"""A/4: sum, difference and dot products, without a figure."""

from exercises.tools import minus, plus, size
from newton_euler import Frame

follows = {"dot_sd": lambda g, sum, diff: sum.dot(diff)}


def vectors(g):
    vector = Frame("axes").vector
    return vector(g.P_x, g.P_y, g.P_z), vector(g.G_x, g.G_y, 0)


def solve(g):
    P, G = vectors(g)
    return {"sum": P + G, "diff": P - G, "dot": P.dot(G), "dot_sd": (P + G).dot(P - G)}


def steps(g):
    P, G = vectors(g)
    return {"dot_i": P.x * G.x, "dot_j": P.y * G.y}


def prove(g):
    """Dot products by the lengths of diagonals; P - G as P + G less twice G."""
    P, G = [g.P_x, g.P_y, g.P_z], [g.G_x, g.G_y, 0]
    dot = lambda a, b: (size(plus(a, b)) ** 2 - size(minus(a, b)) ** 2) / 4
    S = plus(P, G)
    D = minus(S, plus(G, G))
    return {"sum": S, "diff": D, "dot": dot(P, G), "dot_sd": dot(S, D)}


def mistakes(g):
    P, G = vectors(g)
    return {
        "lost_sign": {"diff": solve(g.but(G_y=-g.G_y))["diff"]},
        "magnitudes": {"dot": P.norm() * G.norm()},
        "squares_added": {"dot_sd": P.dot(P) + G.dot(G)},
    }
