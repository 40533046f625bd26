"""5/6: the centre of mass of half a disk by integration."""

from exercises.devices.half_disk import DISK, draw, in_polar, top
from exercises.devices.put_together import on_axis
from exercises.tools import proofs
from newton_euler import pi, sin


def moments(g, element=lambda r: r):
    """Area and first moment; ``element`` is the area per dr dtheta."""
    (area,) = in_polar(g, 0, lambda theta: (g.one,), element)
    (first_y,) = in_polar(g, 1, lambda theta: (sin(theta),), element)
    return area, first_y


centre, solve, steps = on_axis(DISK, "y", "area", moments)


def prove(g):
    """By strips along y, which end at the circle."""
    area, first_y = proofs.integral(lambda x: [top(g, x), top(g, x) ** 2 / 2], -g.R, g.R)
    return {"d": [0, first_y / area, 0], "area": area, "Q_y": first_y}


def mistakes(g):
    return {
        "wire": {"d": DISK.vector(0, 2 * g.R / pi(g.one), 0)},
        "half_radius": {"d": DISK.vector(0, g.R / 2, 0)},
        "no_factor_r": centre(*moments(g, element=lambda r: g.one)),
    }
