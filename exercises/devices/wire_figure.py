"""The wire of 5/10, 7/10, 8/14: a half circle about O, its diameter along x, a leg at its left."""

from exercises.annotations import AnyAxes, Givens, Number, Path, Scalar
from exercises.tools import Sketch, at_angle, mp
from newton_euler import Body, Frame
from newton_euler.bodies import half_ring, rod

WIRE = Frame("wire")


def parts(g: Givens, density: Scalar = 1, side: int = -1) -> list[Body]:
    """Half circle, diameter, leg, which is at ``side``."""
    return [
        half_ring(g.r, WIRE, "z", "y", density=density, name="half circle"),
        rod(2 * g.r, WIRE, "x", density=density, name="diameter"),
        rod(g.c, WIRE.point("leg", side * g.r, 0, g.c / 2), "z", density=density, name="leg"),
    ]


def path(g: Givens) -> tuple[Path, Number, tuple[Number, Number]]:
    """Proof, leg to half circle: position at arc length s, total length, and corners."""
    foot, bend = g.c, g.c + 2 * g.r

    def place(s):
        if s < foot:
            return [-g.r, 0, g.c - s]
        if s < bend:
            return [s - foot - g.r, 0, 0]
        return at_angle(g.r, (s - bend) / g.r)

    return place, bend + mp.pi * g.r, (foot, bend)


def draw(g: Givens, ax: AnyAxes) -> Sketch:
    """The figure of the wire; returns the sketch."""
    s = Sketch(ax, WIRE, azimuth=-60, elevation=25)
    O, left, right = (0, 0, 0), (-g.r, 0, 0), (g.r, 0, 0)
    s.axes(O, WIRE, length=1.6 * g.r)
    s.wire(s.around(O, right, WIRE.k, 3.14159265))
    s.wire([right, left, (-g.r, 0, g.c)])
    s.dimension(O, right, label="r")
    s.dimension(left, (-g.r, 0, g.c), label="c")
    s.label(O, "O")
    return s
