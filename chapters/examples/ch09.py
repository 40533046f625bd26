"""Worked examples of chapter 9, rotation about a fixed axis: an off-centre disk and a bent disk on
a shaft.

The shaft lies along X of the ground, bearing A at -a and bearing B at b from the centre plane of
the disk; psi is counted from Y to y of the shaft.
"""

from newton_euler.bodies.solids import disk
from newton_euler.scenes.planar.rotor import on_shaft


def off_centre_disk(mass, radius, d, a, b, psi, omega):
    """A thin disk at right angles to its shaft, with its centre off the axis (9.2): a
    :class:`~newton_euler.scenes.planar.rotor.RotorScene`.

    d : distance of the centre from the axis, along y of the shaft; psi in rad, omega in rad/s. Any
        consistent units of mass and length.
    Its ``reactions()`` are (9.1)-(9.3).

    >>> rotor = off_centre_disk(mass=2.0, radius=0.1, d=0.01, a=0.2, b=0.3, psi=0.0, omega=10.0)
    >>> print(rotor.reactions().A)
    [0, -1.2, 0] in shaft
    """
    shaft, scene = on_shaft("x", a, b, psi, omega)
    return scene(disk(radius, shaft.point("G", 0, d, 0), "x", mass=mass))


def bent_disk(mass, radius, beta, a, b, psi, omega):
    """A thin disk centred on its shaft, with its normal tilted by beta from the shaft towards y
    (9.3): a RotorScene as above.

    beta, psi in rad, omega in rad/s. Any consistent units of mass and length. Its ``reactions()``
    are (9.4)-(9.6), along the axes of the disk, x along the normal; for those of the shaft ask
    ``A.expressed_in(rotor.shaft)``.

    >>> import math
    >>> rotor = bent_disk(mass=4.0, radius=0.5, beta=math.pi/4, a=0.2, b=0.3, psi=0.0, omega=10.0)
    >>> round(rotor.reactions().A.expressed_in(rotor.shaft).y, 9)  # -m r^2 omega^2 sin(2 beta)/(8 (a + b))
    -25.0
    """
    shaft, scene = on_shaft("x", a, b, psi, omega)
    tilted = shaft.rotate("disk", "z", beta)
    return scene(disk(radius, tilted.point("G", 0, 0, 0), "x", mass=mass))
