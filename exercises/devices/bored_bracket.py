"""The bracket of 5/9 and 7/9: an L-shaped block with a corner at O, and a bore in its base."""

from exercises.annotations import AnyAxes, Givens, Scalar
from exercises.tools import Sketch
from newton_euler import Body, Frame
from newton_euler.bodies import box, cylinder

BRACKET = Frame("bracket")


def block(g: Givens, name: str, x: Scalar, low: Scalar, high: Scalar, density: Scalar = 1) -> Body:
    """A block from 0 to x, of full width, between two heights."""
    middle = BRACKET.point(name, x / 2, g.l_y / 2, (low + high) / 2)
    return box(x, g.l_y, high - low, middle, "x", density=density, name=name)


def parts(g: Givens, density: Scalar = 1) -> tuple[list[Body], list[Body]]:
    axis = BRACKET.point("axis", g.x_h, g.l_y / 2, g.h_b / 2)
    return (
        [
            block(g, "base", g.l_x, 0, g.h_b, density),
            block(g, "wall", g.t_w, g.h_b, g.h_b + g.h_w, density),
        ],
        [cylinder(g.r_h, g.h_b, axis, "z", density=density, name="hole")],
    )


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, BRACKET, azimuth=-113, elevation=28)
    O, high = (0, 0, 0), g.h_b + g.h_w
    end, top = (g.l_x, 0, 0), (g.x_h, g.l_y / 2, g.h_b)
    half = g.h_b / 2  # a plate extends by this on both sides of its outline
    axis = (g.x_h, g.l_y / 2, half)
    outline = [(x, y, half) for x, y in ((0, 0), (g.l_x, 0), (g.l_x, g.l_y), (0, g.l_y))]
    s.plate(outline, [s.around(axis, (g.x_h + g.r_h, g.l_y / 2, half), BRACKET.k)], g.h_b)
    s.box((g.t_w / 2, g.l_y / 2, (g.h_b + high) / 2), BRACKET, (g.t_w, g.l_y, g.h_w))
    s.axes(O, BRACKET, length=1.25 * g.l_x)
    s.dimension(O, end, label="$l_x$")
    s.dimension(O, (0, g.l_y, 0), label="$l_y$")
    s.dimension(end, (g.l_x, 0, g.h_b), label="$h_b$")
    s.dimension((0, g.l_y, high), (g.t_w, g.l_y, high), label="$t_w$")
    s.dimension((g.t_w, 0, g.h_b), (g.t_w, 0, high), label="$h_w$")
    s.line((g.x_h, 0, g.h_b), top)
    s.dimension((0, 0, g.h_b), (g.x_h, 0, g.h_b), label="$x_h$", offset=0)
    s.dimension(top, (g.x_h + g.r_h, g.l_y / 2, g.h_b), label="$r_h$", offset=0)
    s.label(O, "O")
