"""The cone of 5/4 and 7/4, with its apex at O, opening along z."""

import math

from exercises.annotations import AnyAxes, Givens, Number, Scalar
from exercises.tools import Sketch, mp
from newton_euler import Frame

CONE = Frame("cone")


def radius(g: Givens, z: Scalar) -> Scalar:
    return g.r * z / g.h


def tube(g: Givens, s: Number) -> tuple[Number, Number, Number]:
    """Proof, for the thin tube of radius s: volume per ds, height of its lower end, length."""
    low = g.h * s / g.r
    return 2 * mp.pi * s * (g.h - low), low, g.h - low


def draw(g: Givens, ax: AnyAxes) -> None:
    """The cone in outline, with the disk in it visible."""
    azimuth, elevation = -60, 18
    s = Sketch(ax, CONE, azimuth=azimuth, elevation=elevation)
    O, top, end = (0, 0, 0), (0, 0, g.h), (g.r, 0, g.h)
    z = 0.55 * g.h
    s.disk((0, 0, z), CONE.k, radius(g, z), thickness=0.05 * g.h)
    s.ring(top, CONE.k, g.r)
    # where the line of sight is tangent to the side
    aside = math.acos(g.r / g.h * math.tan(math.radians(elevation)))
    for angle in (math.radians(azimuth) - aside, math.radians(azimuth) + aside):
        s.line(O, (g.r * math.cos(angle), g.r * math.sin(angle), g.h), style="solid")
    s.axes(O, CONE, length=1.3 * g.h)
    s.dimension(top, end, label="r", offset=0)
    s.dimension((g.r, 0, 0), end, label="h")
    s.label((radius(g, z), 0, z), "dz", bold=False)
    s.label(O, "O")
