"""7/6: the inertia matrix of half a disk by integration."""

from exercises.devices.half_disk import DISK, draw, in_polar, top
from exercises.devices.inertia import matrix
from exercises.devices.inertia_proof import added, of_points
from exercises.tools import proofs
from newton_euler import cos, pi, sin


def density(g, element=lambda r: r):
    (area,) = in_polar(g, 0, lambda theta: (g.one,), element)
    return g.M / area


def moments(g, sigma, element=lambda r: r):
    """(I_xx, I_yy, I_zz), (I_xy, I_yz, I_zx) in polar coordinates."""

    def squares(theta):
        x, y = cos(theta), sin(theta)
        return y * y, x * x, x * y

    xx, yy, xy = (sigma * x for x in in_polar(g, 2, squares, element))
    return (xx, yy, xx + yy), (xy, 0, 0)


def solve(g):
    return matrix(DISK, *moments(g, density(g)))


def steps(g):
    (xx, yy, zz), (xy, _, _) = moments(g, density(g))
    return {"sigma": density(g), "I_xx": xx, "I_yy": yy, "I_xy": xy, "I_zz": zz}


def prove(g):
    """By strips along y, which end at the arc."""

    def strip(x):
        y = top(g, x)
        return of_points(y, proofs.box(0, y, 0, order=2), [x, y / 2, 0])

    sigma = g.M / proofs.integral(lambda x: top(g, x), -g.R, g.R)
    I = added((sigma, proofs.integral(strip, -g.R, g.R)))
    return {"I_O": I, "sigma": sigma, "I_xx": I[0][0], "I_zz": I[2][2]}


def mistakes(g):
    (xx, yy, zz), _ = moments(g, density(g))
    offset = 4 * g.R / (3 * pi(g.one))
    added_again = g.M * offset**2
    return {
        "halved": matrix(DISK, (xx / 2, yy / 2, zz / 2)),
        "transferred_again": matrix(DISK, (xx + added_again, yy, zz + added_again)),
        "no_factor_r": matrix(DISK, *moments(g, density(g), element=lambda r: g.one)),
    }
