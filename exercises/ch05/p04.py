"""5/4: the centre of mass of a cone by integration."""

from exercises.devices.cone import CONE, draw, radius, tube
from exercises.devices.put_together import on_axis
from exercises.tools import proofs
from newton_euler import integral, pi


def moments(g, radius=radius):
    """Volume and first moment, by thin disks at the height z."""
    disks = lambda f: integral(lambda z: f(z) * (pi(g.one) * radius(g, z) ** 2), 0, g.h)
    return disks(lambda z: 1), disks(lambda z: z)


centre, solve, steps = on_axis(CONE, "z", "volume", moments)


def prove(g):
    """By thin tubes about the axis, from the side up to the base."""

    def tubes(s):
        volume, low, length = tube(g, s)
        return [volume, volume * (low + length / 2)]

    volume, first_z = proofs.integral(tubes, 0, g.r)
    return {"d": [0, 0, first_z / volume], "volume": volume, "Q_z": first_z}


def mistakes(g):
    return {
        "triangle": {"d": CONE.vector(0, 0, 2 * g.h / 3)},
        "quarter_from_apex": {"d": CONE.vector(0, 0, g.h) - solve(g)["d"]},
        "same_radius": centre(*moments(g, radius=lambda g, z: g.r)),
    }
