"""7/8: the inertia matrix of a hemispherical shell."""

from exercises.devices.dome import SHELL, area_of_ring, draw, over_rings, shadow
from exercises.devices.inertia import matrix
from exercises.devices.inertia_proof import added, of_points
from exercises.tools import proofs
from newton_euler import cos, sin
from newton_euler.bodies import hemisphere, ring, spherical_shell


def density(g):
    return g.M / over_rings(g, lambda phi: area_of_ring(g, phi, g.R))


def moments(g, width=lambda g, phi: g.R):
    """(I_xx, I_yy, I_zz) by rings at phi from z; a wrong ``width`` keeps the mass per area."""
    sigma = density(g)

    def thin_ring(phi):
        dm = sigma * area_of_ring(g, phi, width(g, phi))
        middle = SHELL.point("C", 0, 0, g.R * cos(phi))
        return ring(g.R * sin(phi), middle, "z", mass=dm).about(SHELL).moments

    return over_rings(g, thin_ring)


def solve(g):
    return matrix(SHELL, moments(g))


def steps(g):
    xx, _, zz = moments(g)
    return {"sigma": density(g), "I_zz": zz, "I_xx": xx}


def prove(g):
    """By the projection of the shell onto the plane of its rim."""

    def circle(s):
        area, z = shadow(g, s)
        return of_points(area, proofs.ring(s, order=2), [0, 0, z])

    sigma = g.M / proofs.integral(lambda s: shadow(g, s)[0], 0, g.R)
    I = added((sigma, proofs.integral(circle, 0, g.R)))
    return {"I_O": I, "sigma": sigma, "I_zz": I[2][2], "I_xx": I[0][0]}


def mistakes(g):
    solid = hemisphere(g.R, SHELL, "z", mass=g.M).about(SHELL)
    full = spherical_shell(g.R, SHELL, mass=g.M).about(SHELL)
    return {
        "solid": matrix(SHELL, solid.moments),
        "halved": matrix(SHELL, [x / 2 for x in full.moments]),
        "dz_as_width": matrix(SHELL, moments(g, width=lambda g, phi: g.R * sin(phi))),
    }
