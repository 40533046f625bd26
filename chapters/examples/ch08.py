"""Worked examples of chapter 8, Euler's equations: the three rods of ch07 turning about three axes,
one after the other (8.4).
"""

from dataclasses import dataclass

from newton_euler import Body, Frame, Point, Vector
from newton_euler.algebra.scalars import Scalar
from newton_euler.chapters.examples.ch07 import three_rods
from newton_euler.dynamics.momentum import angular_momentum, resultant_moment


@dataclass(frozen=True)
class Turning:
    """A turning body, with its angular momentum ``H`` and the resultant moment ``M`` of the
    external forces, both about ``about`` and seen from ``ground``.
    """

    body: Body
    ground: Frame
    about: Frame | Point
    H: Vector
    M: Vector


def bars_about_x(m: Scalar, length: Scalar, rate: Scalar, acceleration: Scalar) -> Turning:
    """The three rods turning about x (8.4, example 1), a :class:`Turning`: x is not principal, so
    that Euler's equations do not apply.

    M = (2/3 alpha, -(alpha + omega^2)/4, (alpha - omega^2)/4) m L^2 about the origin of the rods'
    axes. Any consistent units of mass and length.

    m : mass of one rod
    rate, acceleration : omega in rad/s, alpha in rad/s^2

    >>> bars_about_x(12.0, 1.0, 2.0, 1.0).M
    Vector(8.0, -15.0, -9.0 in bars)
    """
    ground = Frame("ground")
    frame = ground.rotate("bars", "x", rate=rate, acceleration=acceleration)
    return _turning(three_rods(m, length, frame), ground, frame)


def bars_about_principal_axis(
    m: Scalar, length: Scalar, rate: Scalar, acceleration: Scalar
) -> Turning:
    """The three rods turning about (2, 1, -1) (8.4, example 2), a :class:`Turning`: a principal
    axis, with H and M along it.

    The principal moment is 5/12 m L^2; the arguments are those of :func:`bars_about_x`.

    >>> e = bars_about_principal_axis(12.0, 1.0, 2.0, 3.0)
    >>> round(e.H.norm(), 12), round(e.M.norm(), 12), round(e.M.cross(e.H).norm(), 12)
    (10.0, 15.0, 0.0)
    """
    ground = Frame("ground")
    frame = ground.rotate("bars", (2, 1, -1), rate=rate, acceleration=acceleration)
    return _turning(three_rods(m, length, frame), ground, frame)


def bars_about_mass_centre(
    m: Scalar, length: Scalar, rate: Scalar, acceleration: Scalar
) -> Turning:
    """The three rods turning about the axis through G parallel to z (8.4, example 3), a
    :class:`Turning`.

    M = (3 alpha - omega^2, alpha + 3 omega^2, 10 alpha) m L^2/12 about G, with the whole mass 3 m;
    the book takes the mass of one rod. The arguments are those of :func:`bars_about_x`.

    >>> print(bars_about_mass_centre(12.0, 1.0, 2.0, 1.0).M)
    [-1, 13, 10] in bars
    """
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "z", rate=rate, acceleration=acceleration)
    # G is at the origin of the shaft
    frame = shaft.translate("bars", shaft.point("middle of rod 2", 0, -length / 6, -length / 6))
    body = three_rods(m, length, frame)
    return _turning(body, ground, body.centre)


def _turning(body, ground, about):
    H, M = (f(body, ground, about) for f in (angular_momentum, resultant_moment))
    return Turning(body, ground, about, H, M)
