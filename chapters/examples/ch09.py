"""Worked examples of chapter 9, rotation about a fixed axis: an off-centre disk and a bent disk on
a shaft.

The shaft lies along X of the ground, bearing A at -a and bearing B at b from the middle plane of
the disk; psi is the angle from Y of the ground to y of the shaft, about X.
"""

from newton_euler.algebra.scalars import Scalar
from newton_euler.bodies.solids import disk
from newton_euler.scenes.planar.rotor import RotorScene, on_shaft


def off_centre_disk(
    mass: Scalar, radius: Scalar, d: Scalar, a: Scalar, b: Scalar, psi: Scalar, omega: Scalar
) -> RotorScene:
    """A thin disk at right angles to its shaft, with its centre off the axis (9.2). Its
    ``reactions()`` are (9.1)-(9.3).

    d : distance of the centre from the axis, along y of the shaft
    psi, omega : in rad and rad/s; any consistent units of mass and length

    >>> rotor = off_centre_disk(mass=2.0, radius=0.1, d=0.01, a=0.2, b=0.3, psi=0.0, omega=10.0)
    >>> print(rotor.reactions().A)
    [0, -1.2, 0] in shaft
    """
    shaft, scene = on_shaft("x", a, b, psi, omega)
    return scene(disk(radius, shaft.point("G", 0, d, 0), "x", mass=mass))


def bent_disk(
    mass: Scalar, radius: Scalar, beta: Scalar, a: Scalar, b: Scalar, psi: Scalar, omega: Scalar
) -> RotorScene:
    """A thin disk with its centre on the shaft and its normal tilted by beta from the shaft towards
    y (9.3). Its ``reactions()`` are (9.4)-(9.6).

    The reactions are along the axes of the disk, x along its normal; for components along the axes
    of the shaft use ``A.expressed_in(rotor.shaft)``.

    beta, psi, omega : in rad and rad/s; any consistent units of mass and length

    >>> import math
    >>> rotor = bent_disk(mass=4.0, radius=0.5, beta=math.pi/4, a=0.2, b=0.3, psi=0.0, omega=10.0)
    >>> A = rotor.reactions().A.expressed_in(rotor.shaft)
    >>> round(A.y, 9)  # -m r^2 omega^2 sin(2 beta)/(8 (a + b))
    -25.0
    """
    shaft, scene = on_shaft("x", a, b, psi, omega)
    tilted = shaft.rotate("disk", "z", beta)
    return scene(disk(radius, tilted.point("G", 0, 0, 0), "x", mass=mass))
