"""Energy of a body of revolution on a shaft that turns about z (11/16, 11/19 to 11/21)."""

from dataclasses import dataclass

from exercises.annotations import Motion, Number, Points, Scalar
from exercises.tools import disk, mp, plus, proofs, rot, times
from newton_euler import Frame, Point, solve_rates


@dataclass(frozen=True)
class OnShaft:
    """Ground with z up; the shaft's axes, x along it, y level; the spinning body, its centre C."""

    ground: Frame
    shaft: Frame
    body: Frame
    C: Point


def spinning(Omega: Scalar, spin: Scalar, L: Scalar, *rise: Scalar) -> OnShaft:
    """The body at C, a distance L along the shaft from the origin; the shaft turns about the
    vertical at Omega, inclined upward by the sum of the angles ``rise``, and the body on it at
    ``spin``.
    """
    ground = Frame("ground")
    shaft = ground.rotate("plane", "z", rate=Omega)
    for angle in rise:
        shaft = shaft.rotate("shaft", "-y", angle=angle)
    C = shaft.point("C", L, 0, 0)
    return OnShaft(ground, shaft, shaft.rotate("disk", "x", rate=spin, origin=C), C)


def contact(d: OnShaft, radius: Scalar) -> Point:
    """The lowest point of the rim, in the vertical plane of the shaft."""
    return d.body.point("P", 0, 0, -radius)


def rolling(Omega: Scalar, radius: Scalar, L: Scalar, *rise: Scalar) -> OnShaft:
    """:func:`spinning`, with the spin for which the contact is at rest."""

    def slip(spin):
        d = spinning(Omega, spin, L, *rise)
        return contact(d, radius).velocity(d.ground).expressed_in(d.shaft).y

    return spinning(Omega, solve_rates(slip, 1)[0], L, *rise)


def carried(points: Points, Omega: Number, spin: Number, L: Number, rise: Number = 0) -> Motion:
    """Proof: the motion of mass points, given relative to C along the axes of the shaft."""
    tilt = rot("y", -rise)

    def motion(t):
        along, own = times(rot("z", Omega * t), tilt), rot("x", spin * t)
        return [(u, times(along, plus([L, 0, 0], times(own, p)))) for u, p in points]

    return motion


def unrolled(Omega: Number, radius: Number, path: Number) -> Number:
    """Proof: the spin of a rim that rolls along a circle of radius ``path``, by equal arcs."""
    turn = 2 * mp.pi / Omega  # time
    return -2 * mp.pi * path / radius / turn


def energy_of_disk(
    m: Number, radius: Number, Omega: Number, spin: Number, L: Number, rise: Number = 0
) -> Number:
    """Proof: kinetic energy of the mass points of a thin disk."""
    points = proofs.along_x(disk(radius, order=2))
    return proofs.kinetic_energy(m, carried(points, Omega, spin, L, rise))
