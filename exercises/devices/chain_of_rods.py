"""Three equal rods from O (5/11, 7/11, 7/30, 8/11, 8/17), along x, y, z or from ``first`` on."""

from itertools import pairwise

from exercises.tools import Sketch
from newton_euler import Frame, bodies

CHAIN = Frame("chain")


def corners(g, first="x", edge="a"):
    a = getattr(g, edge)
    places = [in_order(c, first) for c in ((0, 0, 0), (a, 0, 0), (a, a, 0), (a, a, a))]
    return [CHAIN.point(name, *place) for name, place in zip("OABC", places, strict=True)]


def in_order(components, first):
    """Components along x, y, z from those along the first, second and third rod."""
    n = "xyz".index(first)
    return [components[(k - n) % 3] for k in range(3)]


def all_from_O(g):
    """The ends of three rods that by mistake all start at O."""
    O, A, *_ = corners(g)
    return [(O, end) for end in (A, CHAIN.point("B", 0, g.a, 0), CHAIN.point("C", 0, 0, g.a))]


def rods(pairs, **matter):
    matter = matter or {"density": 1}
    return [bodies.simplex(P, Q, name=P.name + Q.name, **matter) for P, Q in pairs]


def path(g, first="x", edge="a"):
    """Proof, along the chain: position at arc length s, total length, and its corners."""
    a = getattr(g, edge)
    place = lambda s: in_order([min(max(s - n * a, 0), a) for n in range(3)], first)
    return place, 3 * a, (a, 2 * a)


def figure(g, ax, first="x", edge="a"):
    """The figure of the chain; returns the sketch."""
    s = Sketch(ax, CHAIN, azimuth=-60, elevation=22)
    O, A, B, C = corners(g, first, edge)
    s.axes(O, CHAIN, length=1.5 * getattr(g, edge))
    for P, Q in pairwise((O, A, B, C)):
        s.rod(P, Q)
        s.dimension(P, Q, label=edge)
    for P in (O, A, B, C):
        s.label(P, P.name)
    return s
