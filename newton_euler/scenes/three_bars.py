"""The assembly of three rods turning about three axes, one after the other (8.4): angular momentum and the moment that keeps it up."""

from dataclasses import dataclass

from ..frames import Frame
from ..momentum import angular_momentum, resultant_moment
from ..vectors import Vector
from .three_rods import three_rods


@dataclass(frozen=True)
class Turning:
    """A body that turns: its angular momentum ``H`` and the resultant moment ``M`` of the external forces about ``about``, seen from ``ground``."""

    body: object
    ground: Frame
    about: object
    H: Vector
    M: Vector


def bars_about_x(m, length, rate, acceleration):
    """Example 1: about the x axis, which is not principal, so that Euler's equations do not apply. ``m`` is the mass of one rod.

    M = (2/3 alpha, -(alpha + omega^2)/4, (alpha - omega^2)/4) m L^2 about the origin of the rods' axes.

    >>> bars_about_x(12.0, 1.0, 2.0, 1.0).M
    Vector(8.0, -15.0, -9.0 in bars)
    """
    ground = Frame("ground")
    frame = ground.rotate("bars", "x", rate=rate, acceleration=acceleration)
    return _turning(three_rods(m, length, frame), ground, frame)


def bars_about_principal_axis(m, length, rate, acceleration):
    """Example 2: about the principal axis (2, 1, -1) with the moment 5/12 m L^2, which needs no moment across it.

    >>> e = bars_about_principal_axis(12.0, 1.0, 2.0, 3.0)
    >>> round(e.H.norm(), 12), round(e.M.norm(), 12), round(e.M.cross(e.H).norm(), 12)
    (10.0, 15.0, 0.0)
    """
    ground = Frame("ground")
    frame = ground.rotate("bars", (2, 1, -1), rate=rate, acceleration=acceleration)
    return _turning(three_rods(m, length, frame), ground, frame)


def bars_about_mass_centre(m, length, rate, acceleration):
    """Example 3: about the axis through G parallel to z. The book takes the mass of one rod for that of three; here all are taken.

    M = (3 alpha - omega^2, alpha + 3 omega^2, 10 alpha) m L^2/12 about G.

    >>> print(bars_about_mass_centre(12.0, 1.0, 2.0, 1.0).M)
    [-1, 13, 10] in bars
    """
    ground = Frame("ground")
    shaft = ground.rotate("shaft", "z", rate=rate, acceleration=acceleration)
    frame = shaft.translate("bars", shaft.point("middle of rod 2", 0, -length / 6, -length / 6))  # G is at the origin of the shaft
    body = three_rods(m, length, frame)
    return _turning(body, ground, body.centre)


def _turning(body, ground, about):
    return Turning(body, ground, about, angular_momentum(body, ground, about), resultant_moment(body, ground, about))
