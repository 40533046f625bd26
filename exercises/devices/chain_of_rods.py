"""Three equal rods from O (5/11, 7/11, 7/30, 8/11, 8/17), along x, y, z or from ``first`` on."""

from collections.abc import Iterable, Sequence
from itertools import pairwise

from exercises.annotations import AnyAxes, Givens, Number, Path, Scalar
from exercises.tools import Sketch
from newton_euler import Body, Frame, Point, bodies

CHAIN = Frame("chain")


def corners(g: Givens, first: str = "x", edge: str = "a") -> list[Point]:
    a = getattr(g, edge)
    places = [in_order(c, first) for c in ((0, 0, 0), (a, 0, 0), (a, a, 0), (a, a, a))]
    return [CHAIN.point(name, *place) for name, place in zip("OABC", places, strict=True)]


def in_order(components: Sequence[Scalar], first: str) -> list[Scalar]:
    """Components along x, y, z from those along the first, second and third rod."""
    n = "xyz".index(first)
    return [components[(k - n) % 3] for k in range(3)]


def all_from_O(g: Givens) -> list[tuple[Point, Point]]:
    """The ends of three rods that by mistake all start at O."""
    O, A, *_ = corners(g)
    return [(O, end) for end in (A, CHAIN.point("B", 0, g.a, 0), CHAIN.point("C", 0, 0, g.a))]


def rods(pairs: Iterable[tuple[Point, Point]], **matter: Scalar) -> list[Body]:
    matter = matter or {"density": 1}
    return [bodies.simplex(P, Q, name=P.name + Q.name, **matter) for P, Q in pairs]


def path(
    g: Givens, first: str = "x", edge: str = "a"
) -> tuple[Path, Number, tuple[Number, Number]]:
    """Proof, along the chain: position at arc length s, total length, and its corners."""
    a = getattr(g, edge)
    place = lambda s: in_order([min(max(s - n * a, 0), a) for n in range(3)], first)
    return place, 3 * a, (a, 2 * a)


def draw(g: Givens, ax: AnyAxes, first: str = "x", edge: str = "a") -> Sketch:
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
