"""The telescoping boom of a parked truck, in polar components and in a moving frame (2.7, 2.11)."""

from dataclasses import dataclass

from ..components import polar
from ..jets import moving


@dataclass(frozen=True)
class TelescopingBoom:
    """A boom AB that turns in the vertical plane about A, the origin; x is horizontal, y up.

    length, elevation : of AB; the elevation in rad above x; numbers or moving. Any consistent units.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> boom = TelescopingBoom(moving(20.0, rate=0.5), moving(0.5235987756, rate=-0.075))
    >>> print(boom.end(ground).velocity(ground))
    [0.5, -1.5, 0] in polar axes of B
    """

    length: object
    elevation: object

    def end(self, ground):
        """B by its polar coordinates: (2.17), (2.18)."""
        return polar(ground, "B", self.length, self.elevation)

    def end_in_boom_frame(self, ground):
        """B as a point of a frame fixed in the boom, with i along it: (2.24), (2.25)."""
        boom = ground.rotate("boom", "z", moving(self.elevation))
        return boom.point("B", self.length, 0, 0)
