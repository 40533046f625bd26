"""8/13: a block that turns about one of its edges."""

from exercises.devices import turning_body
from exercises.tools import Sketch, proofs
from newton_euler import Frame
from newton_euler.bodies import box

BLOCK = Frame("block")
AXIS = "y"


def inertia(g):
    centre = BLOCK.point("G", g.a / 2, g.b / 2, g.c / 2)
    return turning_body.about_origin(BLOCK, [box(g.a, g.b, g.c, centre, "x", mass=g.m)])


solve, steps, follows = turning_body.problem_of(inertia, AXIS, "US")


def prove(g):
    points, centre = proofs.box(g.a, g.b, g.c), [g.a / 2, g.b / 2, g.c / 2]
    return turning_body.prove(g, AXIS, block=turning_body.of_points(g.m, points, centre))


def mistakes(g):
    I = inertia(g)
    about_centre = box(g.a, g.b, g.c, BLOCK, "x", mass=g.m).about(BLOCK)
    return {
        "no_rotation": turning_body.no_rotation(g, I, AXIS),
        "no_products": turning_body.answers(g, turning_body.without_products(I), AXIS),
        "wrong_sign": turning_body.answers(g, turning_body.wrong_sign(I), AXIS),
        "about_centre": turning_body.answers(g, about_centre, AXIS),
    }


def draw(g, ax):
    s = Sketch(ax, BLOCK, azimuth=-115, elevation=22)
    O, X, Y = (0, 0, 0), (g.a, 0, 0), (0, g.b, 0)
    s.box((g.a / 2, g.b / 2, g.c / 2), BLOCK, (g.a, g.b, g.c))
    s.axes(O, BLOCK, length=1.45 * max(g.a, g.b, g.c))
    s.turn((0, 1.25 * max(g.a, g.b, g.c), 0), BLOCK.j, r"$\omega,\ \alpha$")
    s.dimension(O, X, "a")
    s.dimension(O, Y, "b")
    s.dimension(X, (g.a, 0, g.c), "c")
    s.label(O, "O")
