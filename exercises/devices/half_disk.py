"""The half disk of 5/6 and 7/6: its straight edge along x, its middle at O, its arc at y > 0."""

from collections.abc import Callable

from exercises.annotations import AnyAxes, Givens, Number, Scalar, Triple
from exercises.tools import Sketch, mp
from newton_euler import Frame, integral, pi

DISK = Frame("disk")


def in_polar(
    g: Givens, power: int, f: Callable[[Scalar], Triple], element: Callable[[Scalar], Scalar]
) -> Triple:
    """The integral of r^power f(theta), a tuple, over the area; ``element`` is dA/(dr dtheta)."""
    over_r = integral(lambda r: element(r) * r**power, 0, g.R)
    over_theta = integral(f, 0, pi(g.one))
    return tuple(over_r * x for x in over_theta)


def top(g: Givens, x: Number) -> Number:
    """Proof: height of the arc."""
    return mp.sqrt(g.R**2 - x**2)


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, DISK, plane="xy")
    O, end = (0, 0, 0), (g.R, 0, 0)
    s.axes(O, DISK, length=1.35 * g.R, labels=["x", "y", ""])
    s.plate(s.around(O, end, DISK.k, 3.14159265))
    s.dimension(O, end, label="R")
    s.label(O, "O")
