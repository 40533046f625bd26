"""The chain of 5/11 and 7/11: three equal rods from O, along x, y and z."""

from itertools import pairwise

from newton_euler import Frame
from newton_euler.bodies import simplex
from newton_euler.drawing import Sketch

CHAIN = Frame("chain")


def corners(g):
    places = [(0, 0, 0), (g.a, 0, 0), (g.a, g.a, 0), (g.a, g.a, g.a)]
    return [CHAIN.point(name, *place) for name, place in zip("OABC", places, strict=True)]


def all_from_O(g):
    """The mistake of three rods that all start at O: pairs of their ends."""
    O, A, *_ = corners(g)
    return [(O, end) for end in (A, CHAIN.point("B", 0, g.a, 0), CHAIN.point("C", 0, 0, g.a))]


def rods(pairs, **matter):
    matter = matter or {"density": 1}
    return [simplex(P, Q, name=P.name + Q.name, **matter) for P, Q in pairs]


def path(g):
    """Proof, along the chain: the place after a way s, the whole way, and where it has corners."""

    def place(s):
        return [min(max(s - n * g.a, 0), g.a) for n in range(3)]

    return place, 3 * g.a, (g.a, 2 * g.a)


def figure(g, ax):
    s = Sketch(ax, CHAIN, azimuth=-60, elevation=22)
    O, A, B, C = corners(g)
    s.axes(O, CHAIN, length=1.5 * g.a)
    for P, Q in pairwise((O, A, B, C)):
        s.rod(P, Q)
        s.dimension(P, Q, label="a")
    for P in (O, A, B, C):
        s.label(P, P.name)
    return s
