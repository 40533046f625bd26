"""The plate of 5/14 and 7/14, bent along y at O, with a hole and a round top."""

from exercises.annotations import AnyAxes, Givens, Scalar
from exercises.tools import Sketch
from newton_euler import Body, Frame
from newton_euler.bodies import disk, half_disk, plate

PART = Frame("part")


def parts(
    g: Givens, radius: Scalar | None = None, foot: Scalar | None = None
) -> tuple[list[Body], list[Body]]:
    """Two rectangles and the half disk, of ``radius`` with its edge at ``foot``; and the hole."""
    radius, foot = g.w / 2 if radius is None else radius, g.h_v if foot is None else foot
    middle = PART.point("middle", g.l_h / 2, g.w / 2, 0)
    upright = PART.point("upright", 0, g.w / 2, g.h_v / 2)
    top = PART.point("top", 0, g.w / 2, foot)
    hole = PART.point("hole", g.x_h, g.w / 2, 0)
    return (
        [
            plate(g.l_h, g.w, middle, "z", density=g.sigma, name="horizontal rectangle"),
            plate(g.w, g.h_v, upright, "x", density=g.sigma, name="vertical rectangle"),
            half_disk(radius, top, "x", "z", density=g.sigma, name="half disk"),
        ],
        [disk(g.r_h, hole, "z", density=g.sigma, name="hole")],
    )


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, PART, azimuth=35, elevation=22)
    O, along, thick = (0, 0, 0), (0, g.w, 0), 0.04 * g.w
    end, far = (g.l_h, 0, 0), (g.l_h, g.w, 0)
    hole, top = (g.x_h, g.w / 2, 0), (0, g.w / 2, g.h_v)
    s.plate([O, end, far, along], [s.around(hole, (g.x_h + g.r_h, g.w / 2, 0), PART.k)], thick)
    s.plate([O, along, *s.around(top, (0, g.w, g.h_v), PART.i, 3.14159265)], thickness=thick)
    s.axes(O, PART, length=1.2 * g.l_h)
    s.dimension(end, far, label="w")
    s.dimension(along, far, label="$l_h$")
    s.dimension(along, (0, g.w, g.h_v), label="$h_v$")
    s.line((g.x_h, 0, 0), hole)
    s.dimension(O, (g.x_h, 0, 0), label="$x_h$", offset=(0, -0.2 * g.w, 0))
    s.dimension(hole, (g.x_h, g.w / 2 + g.r_h, 0), label="$r_h$", offset=0)
    s.label(O, "O")
