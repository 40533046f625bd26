"""A body on a shaft in two bearings: what the scenes of chapter 9 have in common."""

from dataclasses import dataclass

from ..frames import Frame, Point
from ..mass import Body
from ..rotors import reactions


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
        """The :class:`newton_euler.rotors.Reactions`; ``gravity`` a Vector, or None to leave the weight out."""
        return reactions(self.body, self.A, self.B, self.ground, gravity, self.O)


def on_shaft(axis, a, b, psi, omega, alpha=0):
    """A shaft turned by psi about ``axis`` ("x" or "z") of the ground, its bearings at -a and b from O.

    Returns the frame of the shaft, and a function that makes the :class:`RotorScene` of a body in it.

    >>> from newton_euler.solids import disk
    >>> shaft, scene = on_shaft("x", 0.2, 0.3, 0.0, 10.0)
    >>> scene(disk(0.1, shaft, "x", mass=1.0)).reactions().A.norm()
    0
    """
    ground = Frame("ground")
    shaft = ground.rotate("shaft", axis, psi, omega, alpha)
    A, B = (shaft.point(name, *((s, 0, 0) if axis == "x" else (0, 0, s))) for name, s in (("A", -a), ("B", b)))
    return shaft, lambda body: RotorScene(ground, shaft, body, A, B, shaft.point("O", 0, 0, 0))
