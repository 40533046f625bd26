"""The rods of 5/13 and 7/13: along y from O, up from O to C, and parallel to x from C."""

from exercises.annotations import AnyAxes, Givens, Number, Path, Scalar
from exercises.tools import Sketch
from newton_euler import Body, Frame, Point
from newton_euler.bodies import simplex

WELDED = Frame("welded")


def ends(g: Givens, height: Scalar | None = None) -> tuple[Point, Point, Point, Point, Point]:
    """O, the ends B and C of the first two rods, and both ends of the third, at ``height``."""
    height = g.c if height is None else height
    return (
        WELDED.point("O", 0, 0, 0),
        WELDED.point("B", 0, g.b, 0),
        WELDED.point("C", 0, 0, g.c),
        WELDED.point("S", 0, 0, height),
        WELDED.point("E", g.L, 0, height),
    )


def parts(g: Givens, height: Scalar | None = None, **matter: Scalar) -> list[Body]:
    """The three rods; ``matter``: ``density`` (1 by default) or ``mass`` of each."""
    O, B, C, S, E = ends(g, height)
    matter = matter or {"density": 1}
    names = ("first rod", "second rod", "third rod")
    pairs = zip(names, ((O, B), (O, C), (S, E)), strict=True)
    return [simplex(P, Q, name=name, **matter) for name, (P, Q) in pairs]


def path(g: Givens) -> tuple[Path, Number, tuple[Number, Number]]:
    """Proof, from end to end through O: position at arc length s, total length, and corners."""
    place = lambda s: [max(s - g.b - g.c, 0), max(g.b - s, 0), min(max(s - g.b, 0), g.c)]
    return place, g.b + g.c + g.L, (g.b, g.b + g.c)


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, WELDED, azimuth=-60, elevation=22)
    O, B, C, _, E = ends(g)
    s.axes(O, WELDED, length=1.3 * max(g.b, g.c))
    for P, Q, text in ((O, B, "b"), (O, C, "c"), (C, E, "L")):
        s.rod(P, Q)
        s.dimension(P, Q, label=text)
    s.label(O, "O")
    s.label(C, "C")
