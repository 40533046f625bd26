"""A/19: the unit vector at right angles to two vectors."""

from exercises.tools import Sketch, minus, mp, scaled, size
from newton_euler import Frame

AXES = Frame("axes")


def vectors(g):
    return AXES.vector(g.P_1, g.P_2, g.P_3), AXES.vector(g.G_1, g.G_2, g.G_3)


def solve(g):
    P, G = vectors(g)
    normal = P.cross(G)
    return {"n": normal, "e": normal.direction()}


def steps(g):
    P, G = vectors(g)
    return {"size": P.cross(G).norm()}


def prove(g):
    """i, j or k minus its components in the plane of P and G, made right-handed."""
    P, G = [g.P_1, g.P_2, g.P_3], [g.G_1, g.G_2, g.G_3]
    share = lambda v, away: sum(x * y for x, y in zip(v, away, strict=True)) / size(away) ** 2
    rest = lambda v, away: minus(v, scaled(share(v, away), away))
    across = rest(G, P)
    left = max((rest(rest(v, P), across) for v in ([1, 0, 0], [0, 1, 0], [0, 0, 1])), key=size)
    side = mp.sign(mp.det(mp.matrix([P, G, left])))
    return {"n": left, "e": scaled(side / size(left), left)}


def mistakes(g):
    P, G = vectors(g)
    normal = P.cross(G)
    return {
        "diagonal": {"n": P + G},
        "difference": {"n": P - G},
        "not_divided": {"e": normal},
        "magnitudes": {"e": normal / (P.norm() * G.norm())},
        "G_x_P": {"e": -normal.direction()},
    }


def draw(g, ax):
    """P and G in the horizontal plane at their true angle; e is not to scale."""
    P, G = vectors(g)
    flat = AXES.rotate("flat", "z", angle=-0.6)
    s = Sketch(ax, AXES, azimuth=20, elevation=28)
    along, away = P.dot(G) / P.norm(), P.cross(G).norm() / P.norm()
    at = lambda x, y: flat.vector(x, y, 0).components(AXES)
    p, q, both = at(P.norm(), 0), at(along, away), at(P.norm() + along, away)
    O = (0, 0, 0)
    s.plate([O, p, both, q], shade="light")
    s.arrow(O, p)
    s.arrow(O, q)
    s.label(p, "P")
    s.label(q, "G")
    s.vector(O, AXES.k, "e", kind="plain")
