"""7/7: the inertia matrix of a wire along an arc."""

from exercises.devices.inertia import matrix
from exercises.devices.inertia_proof import added, turned
from exercises.devices.wire_arc import WIRE, along, draw, over
from newton_euler import cos, sin


def moments(g, start=None):
    """(I_xx, I_yy, I_zz), (I_xy, I_yz, I_zx), the wire beginning at the angle ``start``."""
    xx = g.M * over(g, lambda theta: (g.R * cos(theta)) ** 2, start)
    yy = g.M * over(g, lambda theta: (g.R * sin(theta)) ** 2, start)
    xy = g.M * over(g, lambda theta: g.R * cos(theta) * (g.R * sin(theta)), start)
    return (yy, xx, xx + yy), (xy, 0, 0)


def solve(g):
    return matrix(WIRE, *moments(g))


def steps(g):
    (xx, yy, zz), (xy, _, _) = moments(g)
    return {"I_xx": xx, "I_yy": yy, "I_xy": xy, "I_zz": zz}


def prove(g):
    """By the slope of the line from (-R, 0) to the wire instead of an angle."""
    I = added((g.M, along(g, turned)))
    return {"I_O": I, "I_xx": I[0][0], "I_yy": I[1][1], "I_zz": I[2][2]}


def mistakes(g):
    (xx, yy, zz), _ = moments(g)
    return {
        "whole_mass": solve(g.but(M=g.M / (2 * g.R * g.alpha))),
        "exchanged": matrix(WIRE, (yy, xx, zz)),
        "from_0": matrix(WIRE, *moments(g, start=0)),
    }
