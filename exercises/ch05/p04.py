"""5/4: the centre of mass of a cone by integration."""

import math

from mpmath import mp

from exercises import proofs
from exercises.steps import Step
from newton_euler import Frame, integral, pi
from newton_euler.drawing import Sketch

CONE = Frame("cone")


def radius(g, z):
    return g.r * z / g.h


def moments(g, radius=radius):
    """Volume and first moment, by thin disks at the height z."""

    def disks(f):
        return integral(lambda z: f(z) * (pi(g.one) * radius(g, z) ** 2), 0, g.h)

    return disks(lambda z: 1), disks(lambda z: z)


def centre(volume, first_z):
    return {"d": CONE.vector(0, 0, first_z / volume)}


def solve(g):
    return centre(*moments(g))


def steps(g):
    volume, first_z = moments(g)
    yield Step("volume", volume, "m^3", "volume of the cone, by disks at the height z", "5.4")
    yield Step("Q_z", first_z, "m^4", "integral of z dV", "5.4", "5.13")


def prove(g):
    """By tubes about the axis: that of the radius s goes from the side up to the base."""

    def tubes(s):
        low = g.h * s / g.r
        wall = 2 * mp.pi * s
        return [wall * (g.h - low), wall * (g.h**2 - low**2) / 2]

    volume, first_z = proofs.integral(tubes, 0, g.r)
    return {"d": [0, 0, first_z / volume], "volume": volume, "Q_z": first_z}


def mistakes(g):
    return {
        "triangle": {"d": CONE.vector(0, 0, 2 * g.h / 3)},
        "quarter_from_apex": {"d": CONE.vector(0, 0, g.h) - solve(g)["d"]},
        "same_radius": centre(*moments(g, radius=lambda g, z: g.r)),
    }


def draw(g, ax):
    """The side is drawn by its outline alone, so that the disk in it is seen."""
    azimuth, elevation = -60, 18
    s = Sketch(ax, CONE, azimuth=azimuth, elevation=elevation)
    O, top, end = (0, 0, 0), (0, 0, g.h), (g.r, 0, g.h)
    z = 0.55 * g.h
    s.disk((0, 0, z), CONE.k, radius(g, z), thickness=0.05 * g.h)
    s.ring(top, CONE.k, g.r)
    # there one looks along the side
    aside = math.acos(g.r / g.h * math.tan(math.radians(elevation)))
    for angle in (math.radians(azimuth) - aside, math.radians(azimuth) + aside):
        s.line(O, (g.r * math.cos(angle), g.r * math.sin(angle), g.h), style="solid")
    s.axes(O, CONE, length=1.3 * g.h)
    s.dimension(top, end, label="r", offset=0)
    s.dimension((g.r, 0, 0), end, label="h")
    s.label((radius(g, z), 0, z), "dz", bold=False)
    s.label(O, "O")
