"""A/2: a vector of given length and direction."""

from exercises.tools import Sketch, root, scaled, size
from newton_euler import Frame


def to_P(g):
    """The vector from the origin to P."""
    return Frame("axes").vector(g.x, g.y, g.z)


def solve(g):
    return {"V": g.d * to_P(g).direction()}


def steps(g):
    return {"r": to_P(g).norm(), "e": to_P(g).direction()}


def prove(g):
    """By the factor that gives the vector to P the length d."""
    to_P = [g.x, g.y, g.z]
    times = root(lambda n: size(scaled(n, to_P)) - g.d, 0, g.d / g.x)
    return {"V": scaled(times, to_P), "r": g.d / times}


def mistakes(g):
    V = to_P(g)
    return {
        "not_divided": {"V": g.d * V},
        "sum_of_sizes": {"V": g.d / (abs(g.x) + abs(g.y) + abs(g.z)) * V},
        "unit_vector": {"V": V.direction()},
    }


def draw(g, ax):
    axes = Frame("axes")
    s = Sketch(ax, axes, azimuth=35, elevation=22)
    O, P = axes.origin, axes.point("P", g.x, g.y, g.z)
    s.axes(O, axes, length=0.5 * g.d, labels=["i", "j", "k"])
    V = solve(g)["V"].components()
    s.arrow(O, V)
    s.line(P, (g.x, g.y, 0), style="dotted")
    s.line(O, (g.x, g.y, 0), style="dotted")
    s.dot(P, "P", offset=(6, -12))
    s.label(V, "$V$", bold=False)
    s.label(O, "O", offset=(12, 6))
