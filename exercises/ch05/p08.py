"""5/8: the centre of mass of a hemispherical shell."""

from exercises.devices.dome import SHELL, area_of_ring, draw, over_rings, shadow
from exercises.devices.put_together import on_axis
from exercises.tools import proofs
from newton_euler import cos, sin
from newton_euler.bodies import half_ring, hemisphere


def moments(g, width=lambda g, phi: g.R):
    """Area and first moment, by rings at the angle phi from z; ``width`` per dphi."""
    area = lambda phi: area_of_ring(g, phi, width(g, phi))
    ring = lambda phi: (area(phi), g.R * cos(phi) * area(phi))
    return over_rings(g, ring)


centre, solve, steps = on_axis(SHELL, "z", "area", moments)


def prove(g):
    """By the projection of the shell onto the plane of its rim."""

    def circle(s):
        area, z = shadow(g, s)
        return [area, z * area]

    area, first_z = proofs.integral(circle, 0, g.R)
    return {"d": [0, 0, first_z / area], "area": area, "Q_z": first_z}


def mistakes(g):
    return {
        "solid": {"d": hemisphere(g.R, SHELL, "z", density=1).centre.position(SHELL)},
        "dz_as_width": centre(*moments(g, width=lambda g, phi: g.R * sin(phi))),
        "wire": {"d": half_ring(g.R, SHELL, "x", "z", density=1).centre.position(SHELL)},
    }
