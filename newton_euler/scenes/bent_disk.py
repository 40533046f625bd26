"""A thin disk with its centre on the axis of a shaft, and its normal not along it (9.3).

The shaft lies along X of the ground, bearing A at -a and B at b from the centre of the disk; psi is counted from Y to y of the shaft.
"""

from ..solids import disk
from .rotor import on_shaft


def bent_disk(mass, radius, beta, a, b, psi, omega):
    """The disk with its normal tilted by beta (rad) from the shaft towards y: a :class:`~newton_euler.scenes.rotor.RotorScene`, forces (9.4)-(9.6).

    The frame of the body is that of the disk, with x along the normal; ask ``A.expressed_in(scene.shaft)``.

    >>> import math
    >>> rotor = bent_disk(mass=4.0, radius=0.5, beta=math.pi/4, a=0.2, b=0.3, psi=0.0, omega=10.0)
    >>> round(rotor.reactions().A.expressed_in(rotor.shaft).y, 9)  # -m r^2 omega^2 sin(2 beta)/(8 l)
    -25.0
    """
    shaft, scene = on_shaft("x", a, b, psi, omega)
    tilted = shaft.rotate("disk", "z", beta)
    return scene(disk(radius, tilted.point("G", 0, 0, 0), "x", mass=mass))
