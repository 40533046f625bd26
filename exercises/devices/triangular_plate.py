"""The plate of 5/1 and 7/1: a right triangle with its legs along x and y from O."""

from exercises.annotations import AnyAxes, Givens, Points
from exercises.devices.plate_under_curve import PLATE, Height
from exercises.tools import Sketch, mpf, proofs


def height(g: Givens) -> Height:
    return lambda x: g.h * (1 - x / g.b)


def area_points(g: Givens) -> Points:
    """Proof: pairs (area, place), by a map from the unit square whose lower edge goes to O."""
    half = 1 / mpf(2)
    square = [(share, x + half, y + half) for share, (x, y, _) in proofs.box(1, 1, 0)]
    return [(s * g.b * g.h * v, [v * g.b * (1 - u), v * g.h * u, 0]) for s, u, v in square]


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, PLATE, plane="xy")
    O, B, H = (0, 0, 0), (g.b, 0, 0), (0, g.h, 0)
    s.axes(O, PLATE, length=1.3 * max(g.b, g.h), labels=["x", "y", ""])
    s.plate([O, B, H])
    x, end = 0.4 * g.b, 0.45 * g.b
    top = height(g)
    strip = [(x, 0, 0), (end, 0, 0), (end, top(end), 0), (x, top(x), 0)]
    s.plate(strip, shade="dark")
    s.dimension(O, B, label="b")
    s.dimension(O, H, label="h")
    s.dimension((x, 0.3 * g.h, 0), (end, 0.3 * g.h, 0), label="dx", offset=0)
    s.label(O, "O")
