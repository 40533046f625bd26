"""7/16: the inertia matrix of a plate under a parabola by integration."""

from exercises.devices.inertia import matrix
from exercises.devices.inertia_proof import added, of_points
from exercises.devices.parabola_plate import draw, height, start
from exercises.devices.plate_under_curve import PLATE, area, moments_of_inertia, steps_to_inertia
from exercises.tools import proofs


def moments(g, area):
    """Those of the mass spread over this area."""
    return moments_of_inertia(g.m, area, g.a, height(g))


def solve(g):
    return matrix(PLATE, *moments(g, area(g.a, height(g))))


def steps(g):
    yield from steps_to_inertia(g.a, height(g), g.m)


def prove(g):
    """By horizontal strips, from the parabola to x = a."""
    width = lambda y: g.a - start(g, y)
    rod = lambda y: proofs.box(width(y), 0, 0, order=2)
    strip = lambda y: of_points(width(y), rod(y), at=[g.a - width(y) / 2, y, 0])
    sigma = g.m / proofs.integral(width, 0, g.b)
    I = added((sigma, proofs.integral(strip, 0, g.b)))
    return {"I_O": I, "sigma": sigma, "I_zz": I[2][2], "I_xy": -I[0][1]}


def mistakes(g):
    (xx, yy, zz), (xy, _, _) = moments(g, area(g.a, height(g)))
    return {
        "strip_at_its_top": matrix(PLATE, (3 * xx, yy, 3 * xx + yy), (xy, 0, 0)),
        "full_rectangle": matrix(PLATE, *moments(g, g.a * g.b)),
        "plus_sign": matrix(PLATE, (xx, yy, zz), (-xy, 0, 0)),
    }
