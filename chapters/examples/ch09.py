"""Worked examples of chapter 9, rotation about a fixed axis: an off-centre disk (9.2) and a bent
disk (9.3) on a shaft, and any body on a level shaft, with its dead weight (9.5).

The shaft of a disk lies along X of the ground, bearing A at -a and bearing B at b from the centre
plane of the disk; psi is counted from Y to y of the shaft.

The shaft of the rotor of (9.5) lies along z = Z, A at -a and B at b from O, the origin of the axes
of the body; X of the ground points vertically down, and psi is counted from it.
"""

from collections.abc import Callable
from dataclasses import dataclass

from newton_euler import Body, Frame, Point, Vector
from newton_euler.algebra.scalars import Scalar, Triple
from newton_euler.applications.rotors import Reactions, reactions
from newton_euler.bodies import Inertia
from newton_euler.bodies.solids import disk


def off_centre_disk(
    mass: Scalar, radius: Scalar, d: Scalar, a: Scalar, b: Scalar, psi: Scalar, omega: Scalar
) -> "RotorScene":
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
) -> "RotorScene":
    """A thin disk with its centre on the shaft and its normal tilted by beta from the shaft towards
    y (9.3). Its ``reactions()``, (9.4)-(9.6), are along the axes of the disk, x along its normal;
    along the axes of the shaft they are ``A.expressed_in(rotor.shaft)``.

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


@dataclass(frozen=True)
class RotorScene:
    """A body on a shaft: the frames ``ground`` and ``shaft``, the ``body``, its bearings A and B,
    and O between them.
    """

    ground: Frame
    shaft: Frame
    body: Body
    A: Point
    B: Point
    O: Point

    def reactions(self, gravity: Vector | None = None) -> Reactions:
        """The :class:`newton_euler.applications.rotors.Reactions`; ``gravity`` a Vector, or None to
        leave the weight out.
        """
        return reactions(self.body, self.A, self.B, self.ground, gravity, self.O)


def on_shaft(
    axis: str, a: Scalar, b: Scalar, psi: Scalar, omega: Scalar, alpha: Scalar = 0
) -> tuple[Frame, Callable[[Body], RotorScene]]:
    """The frame of a shaft turned by psi about ``axis`` ("x" or "z") of the ground, its bearings at
    -a and b from O, and a function that makes the :class:`RotorScene` of a body in it.

    >>> from newton_euler.bodies.solids import disk
    >>> shaft, scene = on_shaft("x", 0.2, 0.3, 0.0, 10.0)
    >>> scene(disk(0.1, shaft, "x", mass=1.0)).reactions().A.norm()
    0
    """
    ground = Frame("ground")
    shaft = ground.rotate("shaft", axis, psi, omega, alpha)

    def at(name, s):
        return shaft.point(name, *((s, 0, 0) if axis == "x" else (0, 0, s)))

    A, B, O = at("A", -a), at("B", b), shaft.point("O", 0, 0, 0)
    return shaft, lambda body: RotorScene(ground, shaft, body, A, B, O)


def unbalanced_rotor(
    mass: Scalar,
    centre: Triple,
    moments: Triple,
    products: Triple,
    a: Scalar,
    b: Scalar,
    psi: Scalar,
    omega: Scalar,
    alpha: Scalar = 0,
) -> RotorScene:
    """The body of (9.7)-(9.10) in its bearings: a :class:`RotorScene`.

    centre : coordinates of G in the body's axes from O; moments, products : (I_xx, I_yy, I_zz) and
        the integrals (I_xy, I_yz, I_zx) about O
    The downward vertical is ``scene.ground.i``: ``scene.reactions(gravity=9.81*scene.ground.i)``.

    >>> scene = unbalanced_rotor(2.0, (0.1, 0, 0), (1.0, 1.0, 1.0), (0, 0, 0), 0.5, 0.5, 0.0, 3.0)
    >>> # -10 of the weight, -0.9 of m omega^2 x
    >>> round(scene.reactions(gravity=10.0*scene.ground.i).A.x, 6)
    -10.9
    """
    shaft, scene = on_shaft("z", a, b, psi, omega, alpha)
    G = shaft.point("G", *centre)
    inertia = Inertia(shaft.point("O", 0, 0, 0), moments, products, mass, G)
    return scene(Body("rotor", mass, G, inertia, shaft))
