"""7/1: the inertia matrix of a triangle by integration."""

from exercises.catalogue.proofs.digits import weighted
from exercises.devices.inertia import matrix
from exercises.devices.inertia_proof import turned
from exercises.devices.plate_under_curve import PLATE, area, moments_of_inertia, steps_to_inertia
from exercises.devices.triangular_plate import area_points, draw, height


def moments(g):
    return moments_of_inertia(g.M, area(g.b, height(g)), g.b, height(g))


def solve(g):
    return matrix(PLATE, *moments(g))


def steps(g):
    yield from steps_to_inertia(g.b, height(g), g.M)


def prove(g):
    areas, places = zip(*area_points(g), strict=True)
    sigma = g.M / sum(areas)
    I = weighted([sigma * A for A in areas], [turned(place) for place in places])
    return {"I_O": I, "sigma": sigma, "I_zz": I[2][2], "I_xy": -I[0][1]}


def mistakes(g):
    (xx, yy, zz), (xy, _, _) = moments(g)
    bb, hh = g.M * g.b**2 / 3, g.M * g.h**2 / 3
    return {
        "plus_sign": matrix(PLATE, (xx, yy, zz), (-xy, 0, 0)),
        "rectangle": matrix(PLATE, (hh, bb, bb + hh), (g.M * g.b * g.h / 4, 0, 0)),
        "no_product": matrix(PLATE, (xx, yy, zz)),
        "exchanged": matrix(PLATE, (yy, xx, zz), (xy, 0, 0)),
    }
