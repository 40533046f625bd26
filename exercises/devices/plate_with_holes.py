"""The plate of 5/5 and 7/5: a rectangle with a corner at O and six holes in two rows."""

from exercises.annotations import AnyAxes, Givens, Scalar
from exercises.tools import Sketch
from newton_euler import Body, Frame
from newton_euler.bodies import disk, plate

PLATE = Frame("plate")


def places(g: Givens) -> list[tuple[Scalar, Scalar]]:
    return [(x, y) for y in (g.y1, g.y2) for x in (g.x1, g.x2, g.x3)]


def parts(g: Givens, density: Scalar = 1) -> tuple[list[Body], list[Body]]:
    """The full plate, in a list, and the holes."""
    middle = PLATE.point("middle", g.a / 2, g.b / 2, 0)
    full = plate(g.a, g.b, middle, "z", density=density, name="full plate")
    centres = [PLATE.point(f"C_{n}", x, y, 0) for n, (x, y) in enumerate(places(g), 1)]
    hole = lambda n, C: disk(g.r, C, "z", density=density, name=f"hole {n}")
    return [full], [hole(n, C) for n, C in enumerate(centres, 1)]


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, PLATE, plane="xy")
    O, A, B, C = (0, 0, 0), (g.a, 0, 0), (0, g.b, 0), (g.a, g.b, 0)
    rims = [s.around((x, y, 0), (x + g.r, y, 0), PLATE.k) for x, y in places(g)]
    s.axes(O, PLATE, length=1.2 * g.a, labels=["x", "y", ""])
    s.plate([O, A, C, B], rims)
    s.label(O, "O")
    s.dimension(B, C, label="a")
    s.dimension(A, C, label="b")
    for n, (x, name) in enumerate(((g.x1, "$x_1$"), (g.x2, "$x_2$"), (g.x3, "$x_3$"))):
        s.dimension(O, (x, 0, 0), label=name, offset=-0.11 * g.a * (n + 1))
        s.line((x, 0, 0), (x, g.y2, 0), style="centre")
    for n, (y, name) in enumerate(((g.y1, "$y_1$"), (g.y2, "$y_2$"))):
        s.dimension(O, (0, y, 0), label=name, offset=0.11 * g.a * (n + 1))
        s.line((0, y, 0), (g.x3, y, 0), style="centre")
    s.dimension((g.x3, g.y2, 0), (g.x3 + 0.8 * g.r, g.y2 + 0.6 * g.r, 0), label="r", offset=0)
