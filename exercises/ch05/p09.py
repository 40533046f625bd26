"""5/9: the centre of mass of an L-shaped block with a bore."""

from exercises.devices.put_together import centre, chord, sliced, steps_of
from newton_euler import Frame
from newton_euler.bodies import box, cylinder
from newton_euler.drawing import Sketch

BRACKET = Frame("bracket")


def block(g, name, x, low, high):
    """From 0 to x and over all of the width, between two heights."""
    middle = BRACKET.point(name, x / 2, g.l_y / 2, (low + high) / 2)
    return box(x, g.l_y, high - low, middle, "x", density=1, name=name)


def parts(g):
    axis = BRACKET.point("axis", g.x_h, g.l_y / 2, g.h_b / 2)
    return (
        [block(g, "base", g.l_x, 0, g.h_b), block(g, "wall", g.t_w, g.h_b, g.h_b + g.h_w)],
        [cylinder(g.r_h, g.h_b, axis, "z", density=1, name="hole")],
    )


def solve(g):
    return centre(BRACKET, *parts(g))


def steps(g):
    yield from steps_of(BRACKET, *parts(g), content="volume", length="in")


def prove(g):
    def slice_at(x):
        base = (g.l_y - chord(x - g.x_h, g.r_h)) * g.h_b
        wall = g.l_y * g.h_w if x < g.t_w else 0
        whole = base + wall
        return whole, whole * g.l_y / 2, base * g.h_b / 2 + wall * (g.h_b + g.h_w / 2)

    return sliced("volume", slice_at, 0, g.l_x, (g.t_w, g.x_h - g.r_h, g.x_h + g.r_h))


def mistakes(g):
    (base, wall), holes = parts(g)
    return {
        "hole_added": centre(BRACKET, [base, wall, *holes]),
        "wall_from_its_foot": centre(BRACKET, [base, block(g, "wall", g.t_w, 0, g.h_w)], holes),
        "corner_twice": centre(BRACKET, [base, block(g, "wall", g.t_w, 0, g.h_b + g.h_w)], holes),
    }


def draw(g, ax):
    s = Sketch(ax, BRACKET, azimuth=-113, elevation=28)
    O, high = (0, 0, 0), g.h_b + g.h_w
    end, top = (g.l_x, 0, 0), (g.x_h, g.l_y / 2, g.h_b)
    half = g.h_b / 2  # a plate is as thick on either side of its outline
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
