"""The disk of 5/12 and 7/12: about O, with a hole whose centre is on x."""

from exercises.annotations import AnyAxes, Givens, Number, Scalar
from exercises.tools import Sketch, mp
from newton_euler import Body, Frame
from newton_euler.bodies import disk

DISK = Frame("disk")


def parts(g: Givens, density: Scalar = 1) -> tuple[list[Body], list[Body]]:
    full = disk(g.R, DISK, "z", density=density, name="full disk")
    return [full], [disk(g.r, DISK.point("C", g.e, 0, 0), "z", density=density, name="hole")]


def rim(g: Givens, c: Number, s: Number) -> Number:
    """Proof: distance from the hole's centre to the disk's rim in the direction (c, s)."""
    return mp.sqrt(g.R**2 - (g.e * s) ** 2) - g.e * c


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, DISK, plane="xy")
    O, C = (0, 0, 0), (g.e, 0, 0)
    s.axes(O, DISK, length=1.3 * g.R, labels=["x", "y", ""])
    s.plate(s.around(O, (g.R, 0, 0), DISK.k), [s.around(C, (g.e + g.r, 0, 0), DISK.k)])
    s.dot(C)
    s.dimension(O, (-0.8 * g.R, 0.6 * g.R, 0), label="R", offset=0)
    s.dimension(C, (g.e + 0.6 * g.r, 0.8 * g.r, 0), label="r", offset=0)
    s.dimension(O, C, label="e", offset=-1.3 * g.r)
    s.label(O, "O")
