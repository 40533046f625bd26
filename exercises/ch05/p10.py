"""5/10: the centre of mass of a figure of wire."""

from mpmath import mp

from exercises.devices.put_together import centre, steps_of, unweighed, walked
from newton_euler import Frame
from newton_euler.bodies import Body, half_disk, half_ring, rod
from newton_euler.drawing import Sketch

WIRE = Frame("wire")


def parts(g):
    leg = WIRE.point("leg", -g.r, 0, g.c / 2)
    return [
        half_ring(g.r, WIRE, "z", "y", density=1, name="half circle"),
        rod(2 * g.r, WIRE, "x", density=1, name="diameter"),
        rod(g.c, leg, "z", density=1, name="leg"),
    ]


def solve(g):
    return centre(WIRE, parts(g))


def steps(g):
    yield from steps_of(WIRE, parts(g), content="length", length="mm")


def prove(g):
    """Down the leg, along the diameter and back round the half circle."""
    foot, bend = g.c, g.c + 2 * g.r

    def path(s):
        if s < foot:
            return [-g.r, 0, g.c - s]
        if s < bend:
            return [s - foot - g.r, 0, 0]
        turned = (s - bend) / g.r
        return [g.r * mp.cos(turned), g.r * mp.sin(turned), 0]

    return walked(path, bend + mp.pi * g.r, (foot, bend))


def mistakes(g):
    half, diameter, leg = parts(g)
    sheet = half_disk(g.r, WIRE, "z", "y", density=1)
    return {
        "half_disk": centre(WIRE, [Body("half", half.mass, sheet.centre), diameter, leg]),
        "no_diameter": centre(WIRE, [half, leg]),
        "not_weighed": unweighed(WIRE, g.one, [part.centre for part in parts(g)]),
    }


def draw(g, ax):
    s = Sketch(ax, WIRE, azimuth=-60, elevation=25)
    O, left, right = (0, 0, 0), (-g.r, 0, 0), (g.r, 0, 0)
    s.axes(O, WIRE, length=1.6 * g.r)
    s.wire(s.around(O, right, WIRE.k, 3.14159265))
    s.wire([right, left, (-g.r, 0, g.c)])
    s.dimension(O, right, label="r")
    s.dimension(left, (-g.r, 0, g.c), label="c")
    s.label(O, "O")
