"""The thin half ring (wire) of 7/26 and 7/27: G is its centre of mass, M the middle of its arc."""

from collections.abc import Callable

from exercises.annotations import Givens, Number, Scalar, Steps
from exercises.tools import Step, mp, proofs
from newton_euler import Body, Frame, Point
from newton_euler.bodies import half_disk, half_ring

RING = Frame("ring")  # its origin is the centre of the circle, its x axis along the diameter


def half(g: Givens) -> tuple[Body, Point]:
    """The body, below the diameter, and M."""
    return half_ring(g.r, RING, "z", "-y", mass=g.m), RING.point("M", 0, -g.r, 0)


def depth(part: Body) -> Scalar:
    """The depth of G below the diameter."""
    return -part.centre.position(RING).y


def from_G(g: Givens, own: Scalar, d: Scalar) -> Scalar:
    """The moment about an axis through M, from ``own`` about its parallel through G, at depth d."""
    return own + g.m * (g.r - d) ** 2


def with_half_disk(g: Givens, at_centre: Scalar) -> Scalar:
    """The mistake of the half disk, from the moment about its centre to that about M."""
    d = depth(half_disk(g.r, RING, "z", "-y", mass=g.m))
    return from_G(g, at_centre - g.m * d**2, d)


def half_steps(g: Givens, axis: str, through: str) -> Steps:
    """The steps via G; ``axis``, and ``through``, the words for its parallel through G."""
    part, M = half(g)
    yield Step("d", depth(part), "m", "distance of the centre of mass from the diameter, 2*r/pi",
               "5.4", "5.13")  # fmt: skip
    yield Step("own", part.inertia.moment(axis), "kg*m^2", f"moment about {through}, by m*d^2 "
               "smaller than at the centre of the circle", "7.8", "7.26")  # fmt: skip
    yield Step("transfer", part.about(M).terms["transfer"].moment(axis), "kg*m^2",
               "transfer to the middle of the arc, m*(r - d)^2", "7.8", "7.26")  # fmt: skip


def mean_over_half(f: Callable[[Number, Number], Number], r: Number) -> Number:
    """Proof: the mean of f(x, y) over the arc."""
    return proofs.integral(lambda t: f(r * mp.cos(t), -r * mp.sin(t)), 0, mp.pi) / mp.pi
