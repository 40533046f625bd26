"""The plate of 5/16 and 7/16: between the x axis, a parabola with its vertex at O, and x = a."""

from exercises.annotations import AnyAxes, Givens, Number
from exercises.devices.plate_under_curve import PLATE, Height
from exercises.tools import Sketch, mp


def height(g: Givens) -> Height:
    return lambda x: g.b * x**2 / g.a**2


def start(g: Givens, y: Number) -> Number:
    """Proof: left end of the horizontal strip at this height, which ends at x = a."""
    return g.a * mp.sqrt(y / g.b)


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, PLATE, plane="xy")
    O, end = (0, 0, 0), (g.a, 0, 0)
    edge = [(g.a * n / 40, height(g)(g.a * n / 40), 0) for n in range(41)]
    s.axes(O, PLATE, length=1.3 * max(g.a, g.b), labels=["x", "y", ""])
    s.plate([*edge, end])
    s.dimension(O, end, label="a")
    s.dimension(end, edge[-1], label="b")
    s.label(O, "O")
