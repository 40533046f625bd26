"""A thin disk on a shaft at right angles to it, with its centre off the axis (9.2).

The shaft lies along X of the ground, bearing A at -a and B at b from the plane of the disk; y of the shaft points from the axis to the centre of the
disk, psi is counted from Y to y.
"""

from ..solids import disk
from .rotor import on_shaft


def off_centre_disk(mass, radius, d, a, b, psi, omega):
    """The disk with its centre at the distance d from the axis: a :class:`~newton_euler.scenes.rotor.RotorScene` with the forces (9.1)-(9.3).

    >>> rotor = off_centre_disk(mass=2.0, radius=0.1, d=0.01, a=0.2, b=0.3, psi=0.0, omega=10.0)
    >>> print(rotor.reactions().A)
    [0, -1.2, 0] in shaft
    """
    shaft, scene = on_shaft("x", a, b, psi, omega)
    return scene(disk(radius, shaft.point("G", 0, d, 0), "x", mass=mass))
