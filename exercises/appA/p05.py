"""A/5: the component of a vector along a directed line."""

from exercises.tools import Sketch, minus, plus, rate, root, scaled, size
from newton_euler import Frame

AXES = Frame("axes")
follows = {"comp": lambda g, PG: PG.dot(PG.frame.vector(*steps(g)["e"].components()))}


def points(g):
    """P, G, A, B."""
    places = {n: (getattr(g, f"{n}_x"), getattr(g, f"{n}_y"), getattr(g, f"{n}_z")) for n in "PGAB"}
    return [AXES.point(n, *at) for n, at in places.items()]


def solve(g):
    P, G, A, B = points(g)
    return {"PG": G - P, "comp": (G - P).dot((B - A).direction())}


def steps(g):
    _, _, A, B = points(g)
    return {"AB": B - A, "l": (B - A).norm(), "e": (B - A).direction()}


def prove(g):
    """From the point of the line nearest to P to the one nearest to G."""
    P, G = [g.P_x, g.P_y, g.P_z], [g.G_x, g.G_y, g.G_z]
    A, B = [g.A_x, g.A_y, g.A_z], [g.B_x, g.B_y, g.B_z]
    on_line = lambda t: plus(scaled(1 - t, A), scaled(t, B))

    def nearest(C):
        return root(lambda t: rate(lambda u: size(minus(on_line(u), C)) ** 2, t), -100, 100)

    AB = rate(on_line)
    return {
        "PG": rate(lambda t: plus(scaled(1 - t, P), scaled(t, G))),
        "comp": (nearest(G) - nearest(P)) * size(AB),
        "AB": AB,
        "l": size(minus(A, B)),
    }


def mistakes(g):
    P, G, A, B = points(g)
    right = solve(g)
    return {
        "not_divided": {"comp": (G - P).dot(B - A)},
        "no_sign": {"comp": abs(right["comp"])},
        "from_G_to_P": {"PG": -right["PG"], "comp": -right["comp"]},
    }


def draw(g, ax):
    P, G, A, B = points(g)
    s = Sketch(ax, AXES, azimuth=-60, elevation=22)
    s.axes(AXES.origin, AXES, length=3, labels=["i", "j", "k"])
    s.line(P, G, style="solid")
    s.arrow(A, B)
    for C in (P, G, A, B):
        s.dot(C, C.name)
