"""7/4: the inertia matrix of a cone at its apex by integration."""

from exercises.devices.cone import CONE, draw, radius, tube
from exercises.devices.inertia import matrix
from exercises.devices.inertia_proof import added, of_points
from exercises.tools import proofs
from newton_euler import bodies, integral, pi


def density(g, radius=radius):
    return g.M / integral(lambda z: pi(g.one) * radius(g, z) ** 2, 0, g.h)


def moments(g, radius=radius, transfer=1):
    """(I_xx, I_yy, I_zz) by thin disks at height z; ``transfer`` scales the parallel-axis term."""
    rho = density(g, radius)
    disk = lambda z: bodies.disk(radius(g, z), CONE.point("C", 0, 0, z), "z", density=rho)
    but = lambda **zero: integral(lambda z: disk(z).about(CONE).reweighted(**zero).moments, 0, g.h)
    own, far = but(transfer=0), but(own=0)
    return [x + transfer * y for x, y in zip(own, far, strict=True)]


def solve(g):
    I_xx, _, I_zz = moments(g)
    return matrix(CONE, (I_xx, I_xx, I_zz))


def steps(g):
    xx, _, zz = moments(g)
    return {"rho": density(g), "I_zz": zz, "own": moments(g, transfer=0)[0], "I_xx": xx}


def prove(g):
    """By tubes about the axis, from the side up to the base."""

    def wall(place):
        s = place[0] + g.r / 2
        volume, low, length = tube(g, s)
        points = proofs.raised(proofs.ring(s, order=2), length)
        return of_points(volume, points, [0, 0, low + length / 2])

    rho = g.M / proofs.integral(lambda s: tube(g, s)[0], 0, g.r)
    I = added((rho * g.r, proofs.mean(wall, proofs.box(g.r, 0, 0))))
    return {"I_O": I, "rho": rho, "I_zz": I[2][2], "I_xx": I[0][0]}


def mistakes(g):
    xx, yy, zz = moments(g)
    own = moments(g, transfer=0)
    at_G = g.M * (3 * g.h / 4) ** 2
    return {
        "no_z": matrix(CONE, (own[0], own[1], zz)),
        "at_G": matrix(CONE, (xx - at_G, yy - at_G, zz)),
        "cylinder": matrix(CONE, moments(g, radius=lambda g, z: g.r)),
    }
