"""5/13: the centre of mass of three welded rods of different lengths."""

from exercises.devices.put_together import centre, steps_of, unweighed, walked
from newton_euler import Frame
from newton_euler.bodies import simplex
from newton_euler.drawing import Sketch

WELDED = Frame("welded")


def ends(g, height=None):
    """O, the end B of the first rod, the end C of the second, and start and end of the third, which
    is at the ``height``.
    """
    height = g.c if height is None else height
    return (
        WELDED.point("O", 0, 0, 0),
        WELDED.point("B", 0, g.b, 0),
        WELDED.point("C", 0, 0, g.c),
        WELDED.point("S", 0, 0, height),
        WELDED.point("E", g.L, 0, height),
    )


def parts(g, height=None):
    O, B, C, S, E = ends(g, height)
    names = ("first rod", "second rod", "third rod")
    pairs = zip(names, ((O, B), (O, C), (S, E)), strict=True)
    return [simplex(P, Q, density=1, name=name) for name, (P, Q) in pairs]


def solve(g):
    return centre(WELDED, parts(g))


def steps(g):
    yield from steps_of(WELDED, parts(g), content="length", length="m")


def prove(g):
    """Along the wire from the end of the first rod through O to the end of the third."""

    def path(s):
        return [max(s - g.b - g.c, 0), max(g.b - s, 0), min(max(s - g.b, 0), g.c)]

    return walked(path, g.b + g.c + g.L, (g.b, g.b + g.c))


def mistakes(g):
    whole = g.b + g.c + g.L
    return {
        "equal_weights": unweighed(WELDED, g.one, [rod.centre for rod in parts(g)]),
        "third_at_the_bottom": centre(WELDED, parts(g, height=0)),
        "without_first_length": {"d": solve(g)["d"] * (whole / (g.c + g.L))},
    }


def draw(g, ax):
    s = Sketch(ax, WELDED, azimuth=-60, elevation=22)
    O, B, C, _, E = ends(g)
    s.axes(O, WELDED, length=1.3 * max(g.b, g.c))
    for P, Q, text in ((O, B, "b"), (O, C, "c"), (C, E, "L")):
        s.rod(P, Q)
        s.dimension(P, Q, label=text)
    s.label(O, "O")
    s.label(C, "C")
