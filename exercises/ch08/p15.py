"""8/15: a bent sheet that turns about one of its edges."""

from exercises.devices import turning_body
from exercises.tools import Sketch, proofs
from newton_euler import Frame
from newton_euler.bodies import plate

SHEET = Frame("sheet")
AXIS = "x"


def inertia(g):
    level = SHEET.point("middle", g.a / 2, g.b / 2, 0)
    upright = SHEET.point("upright", g.a / 2, g.b, g.c / 2)
    return turning_body.about_origin(SHEET, [
        plate(g.a, g.b, level, "z", density=g.rho, name="level part"),
        plate(g.c, g.a, upright, "y", density=g.rho, name="upright part"),
    ])  # fmt: skip


solve, steps, follows = turning_body.problem_of(inertia, AXIS)


def prove(g):
    over = turning_body.of_points
    level = over(g.rho * g.a * g.b, proofs.box(g.a, g.b, 0), [g.a / 2, g.b / 2, 0])
    upright = over(g.rho * g.a * g.c, proofs.box(g.a, 0, g.c), [g.a / 2, g.b, g.c / 2])
    return turning_body.prove(g, AXIS, level=level, upright=upright)


def mistakes(g):
    I = inertia(g)
    near = turning_body.added_to_moment(I, AXIS, -I.terms["upright part"].mass * g.b**2)
    return {
        "no_rotation": turning_body.no_rotation(g, I, AXIS),
        "wrong_sign": turning_body.answers(g, turning_body.wrong_sign(I), AXIS),
        "no_distance": turning_body.answers(g, near, AXIS),
        "no_products": turning_body.answers(g, turning_body.without_products(I), AXIS),
    }


def draw(g, ax):
    s = Sketch(ax, SHEET, azimuth=-120, elevation=26)
    O, X, Y = (0, 0, 0), (g.a, 0, 0), (0, g.b, 0)
    end, size = (g.a, g.b, 0), max(g.a, g.b, g.c)
    thick = 0.02 * size
    s.plate([O, X, end, Y], thickness=thick)
    s.plate([Y, end, (g.a, g.b, g.c), (0, g.b, g.c)], thickness=thick)
    s.axes(O, SHEET, length=1.45 * size)
    s.turn((1.25 * size, 0, 0), SHEET.i, r"$\omega,\ \alpha$")
    s.dimension(O, X, "a")
    s.dimension(O, Y, "b")
    s.dimension(end, (g.a, g.b, g.c), "c")
    s.label(O, "O")
