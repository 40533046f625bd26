"""A thin disk on a shaft at right angles to it, its centre off the axis (9.2); the same disk bent out of square, its centre on the axis (9.3).

The shaft lies along X of the ground, bearing A at -a and B at b from the disk's middle plane; y of the shaft points from the axis to the centre of the
disk, psi from Y to y. ``rotor.reactions()`` gives (9.1)-(9.6).

>>> rotor = off_centre_disk(mass=2.0, radius=0.1, d=0.01, a=0.2, b=0.3, psi=0.0, omega=10.0)
>>> print(rotor.reactions().A)
[0, -1.2, 0] in shaft
"""

from dataclasses import dataclass

from ..frames import Frame, Point
from ..mass import Body
from ..rotors import reactions
from ..solids import disk


@dataclass(frozen=True)
class RotorScene:
    """A body on a shaft: the frames ``ground`` and ``shaft``, the ``body``, its bearings A and B, and O between them."""

    ground: Frame
    shaft: Frame
    body: Body
    A: Point
    B: Point
    O: Point

    def reactions(self, gravity=None):
        """The :class:`newton_euler.rotors.Reactions`; gravity a Vector, or None to leave the weight out."""
        return reactions(self.body, self.A, self.B, self.ground, gravity, self.O)


def on_shaft(axis, a, b, psi, omega, alpha=0):
    """Ground and shaft, turned by psi about ``axis`` ("x" or "z"), with bearings and O: a function from the body to the scene."""
    ground = Frame("ground")
    shaft = ground.rotate("shaft", axis, psi, omega, alpha)
    A, B = (shaft.point(name, *((s, 0, 0) if axis == "x" else (0, 0, s))) for name, s in (("A", -a), ("B", b)))
    O = shaft.point("O", 0, 0, 0)
    return shaft, lambda body: RotorScene(ground, shaft, body, A, B, O)


def off_centre_disk(mass, radius, d, a, b, psi, omega):
    """The disk of 9.2, its centre at the distance d from the axis: a :class:`RotorScene`. Forces on it (9.3)."""
    shaft, scene = on_shaft("x", a, b, psi, omega)
    return scene(disk(radius, shaft.point("G", 0, d, 0), "x", mass=mass))


def bent_disk(mass, radius, beta, a, b, psi, omega):
    """The disk of 9.3, its normal tilted by beta (rad) from the shaft towards y: a :class:`RotorScene`. Forces on it (9.6)."""
    shaft, scene = on_shaft("x", a, b, psi, omega)
    tilted = shaft.rotate("disk", "z", beta)
    return scene(disk(radius, tilted.point("G", 0, 0, 0), "x", mass=mass))
