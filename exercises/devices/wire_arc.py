"""The wire of 5/7 and 7/7: an arc about O, from the angle -alpha to alpha."""

from collections.abc import Callable

from exercises.annotations import AnyAxes, Givens, Number, Scalar
from exercises.catalogue.proofs.digits import Value, weighted
from exercises.tools import Sketch, mp, proofs
from newton_euler import Frame, cos, integral, sin

WIRE = Frame("wire")


def over(g: Givens, f: Callable[[Scalar], Scalar], start: Scalar | None = None) -> Scalar:
    """The integral of f(theta) R dtheta along the wire."""
    return integral(lambda theta: f(theta) * g.R, -g.alpha if start is None else start, g.alpha)


def along(g: Givens, f: Callable[[list[Number]], Value]) -> Value:
    """Proof: the integral of f(place) ds along the wire, f a list or matrix, over the slope u =
    y/(R + x) of the line from (-R, 0), a rational parametrization of the circle.
    """
    place = lambda u: [g.R * (1 - u * u) / (1 + u * u), 2 * g.R * u / (1 + u * u), 0]
    per_slope = lambda u: weighted([proofs.size(proofs.rate(place, u))], [f(place(u))])
    steepest = mp.sin(g.alpha) / (1 + mp.cos(g.alpha))
    return proofs.integral(per_slope, -steepest, steepest)


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, WIRE, plane="xy")
    O = (0, 0, 0)
    low = (g.R * cos(g.alpha), -g.R * sin(g.alpha), 0)
    high = (g.R * cos(g.alpha), g.R * sin(g.alpha), 0)
    s.axes(O, WIRE, length=1.35 * g.R, labels=["x", "y", ""])
    s.wire(s.around(O, low, WIRE.k, 2 * g.alpha))
    for end in (low, high):
        s.line(O, end)
        s.arc(O, (g.R, 0, 0), end, label=r"$\alpha$")
    s.dimension(O, (g.R * cos(0.4 * g.alpha), g.R * sin(0.4 * g.alpha), 0), label="R", offset=0)
    s.label(O, "O")
