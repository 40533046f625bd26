"""The wire of a coil spring, a helix, drawn out from flat to straight (3.2)."""

from dataclasses import dataclass

from ..frames import Frame
from ..paths import frenet_along
from ..scalars import cos, sin, sqrt


@dataclass(frozen=True)
class Spring:
    """A right-handed helix of ``radius`` about z that rises by ``rise`` per radian (the pitch over 2 pi).

    >>> spring = Spring(radius=3.0, rise=4.0)
    >>> spring.flexure, spring.torsion
    (0.12, -0.16)
    """

    radius: object
    rise: object

    def path(self, theta):
        """(x, y, z) at the azimuth theta."""
        return self.radius * cos(theta), self.radius * sin(theta), self.rise * theta

    wire = property(lambda self: sqrt(self.radius**2 + self.rise**2), doc="length of wire per radian")
    flexure = property(lambda self: self.radius / (self.radius**2 + self.rise**2), doc="f, the same all along")
    torsion = property(lambda self: -self.rise / (self.radius**2 + self.rise**2), doc="tau with the book's sign: negative for a right-handed helix")

    def intrinsic(self, theta, ground=None):
        """The Frenet triad and components of a point that climbs at 1 rad/s, at the azimuth theta (rad, a plain number or moving)."""
        return frenet_along(self.path, theta, ground or Frame("ground"), name="the wire")

    @staticmethod
    def drawn_out(wire, slope):
        """The spring with ``wire`` of length per radian whose wire rises at the angle ``slope`` (rad): 0 is flat, a quarter turn is straight.

        Drawn straight, f goes to 0 and the torsion to -1/wire, which is finite (the book says infinite); on the straight wire itself there is
        no e_n and so no torsion.

        >>> round(Spring.drawn_out(5.0, 1.57).torsion, 6)
        -0.2
        """
        return Spring(wire * cos(slope), wire * sin(slope))
