"""The body of 5/3 and 7/3: a block with a corner at O, and a cylinder on top."""

from exercises.annotations import AnyAxes, Givens, Scalar
from exercises.tools import Sketch
from newton_euler import Body, Frame
from newton_euler.bodies import box, cylinder

BLOCK = Frame("block")


def parts(g: Givens, foot: Scalar | None = None, density: Scalar = 1) -> list[Body]:
    """Block and cylinder; ``foot`` is the height of the base of the cylinder."""
    foot = g.c if foot is None else foot
    middle = BLOCK.point("middle", g.a / 2, g.b / 2, g.c / 2)
    axis = BLOCK.point("axis", g.x_c, g.b / 2, foot + g.l_c / 2)
    return [
        box(g.a, g.b, g.c, middle, "x", density=density, name="block"),
        cylinder(g.r_c, g.l_c, axis, "z", density=density, name="cylinder"),
    ]


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, BLOCK, azimuth=-120, elevation=22)
    O, foot, top = (0, 0, 0), (g.x_c, g.b / 2, g.c), (g.x_c, g.b / 2, g.c + g.l_c)
    right = (0.87 * g.r_c, -0.5 * g.r_c, 0)  # to the right in the figure
    s.box((g.a / 2, g.b / 2, g.c / 2), BLOCK, (g.a, g.b, g.c))
    s.cylinder(foot, top, g.r_c)
    s.axes(O, BLOCK, length=1.25 * g.a)
    s.label(O, "O")
    s.dimension(O, (g.a, 0, 0), label="a")
    s.dimension(O, (0, g.b, 0), label="b")
    s.dimension((g.a, 0, 0), (g.a, 0, g.c), label="c")
    side = [tuple(x + y for x, y in zip(P, right, strict=True)) for P in (foot, top)]
    s.dimension(side[0], side[1], label="$l_c$")
    s.dimension(top, side[1], label="$r_c$", offset=0)
    s.line((g.x_c, 0, g.c), foot)
    s.dimension((0, 0, g.c), (g.x_c, 0, g.c), label="$x_c$", offset=0)
