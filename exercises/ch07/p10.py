"""7/10: the inertia matrix of a figure of wire."""

from exercises.devices.inertia import matrix, problem_of, together, whole
from exercises.devices.inertia_proof import added, along_path
from exercises.devices.wire_figure import WIRE, draw, parts, path
from newton_euler.bodies import disk

solve, steps = problem_of(WIRE, lambda g: parts(g, g.lam), "kg", "mm", "kg*m^2", at_O=["diameter"])


def prove(g):
    leg, diameter, half = along_path(g.lam, *path(g))
    I = added((1, leg), (1, diameter), (1, half))
    return {"I_O": I, "I_leg": leg, "I_diameter": diameter, "I_half": half}


def mistakes(g):
    half, diameter, leg = parts(g, g.lam)
    I = together(WIRE, [half, diameter, leg])
    # half of a disk of twice the mass has the same moments
    sheet = disk(g.r, WIRE, "z", mass=half.mass)
    xx, yy, zz = I.moments
    near = leg.mass * g.r**2
    return {
        "leg_on_the_right": whole(WIRE, parts(g, g.lam, side=1)),
        "half_disk": whole(WIRE, [sheet, diameter, leg]),
        "no_distance": matrix(WIRE, (xx, yy - near, zz - near), I.products),
        "no_diameter": whole(WIRE, [half, leg]),
    }
