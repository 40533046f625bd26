"""The satellite of 5/2 and 7/2: two touching spheres, the larger about O, x through both."""

from collections.abc import Callable

from exercises.annotations import AnyAxes, Givens, Number, Points, Scalar
from exercises.tools import Sketch, proofs
from newton_euler import Body, Frame, bodies

SATELLITE = Frame("satellite")


def parts(
    g: Givens, distance: Scalar | None = None, shape: Callable[..., Body] = bodies.sphere
) -> list[Body]:
    far = SATELLITE.point("centre", g.R1 + g.R2 if distance is None else distance, 0, 0)
    return [
        shape(g.R1, SATELLITE, mass=g.m1, name="larger sphere"),
        shape(g.R2, far, mass=g.m2, name="smaller sphere"),
    ]


def spheres(g: Givens) -> list[tuple[Number, Points, list[Number]]]:
    """Proof: mass, mass points and centre of each sphere."""
    return [
        (g.m1, proofs.ball(g.R1, order=2), [0, 0, 0]),
        (g.m2, proofs.ball(g.R2, order=2), [g.R1 + g.R2, 0, 0]),
    ]


def draw(g: Givens, ax: AnyAxes) -> None:
    s = Sketch(ax, SATELLITE, plane="xz")
    O, C = (0, 0, 0), (g.R1 + g.R2, 0, 0)
    s.sphere(O, g.R1)
    s.sphere(C, g.R2)
    s.axes(O, SATELLITE, length=1.35 * (g.R1 + g.R2), labels=["x", "", "z"])
    s.dot(C)
    s.dimension(O, (-0.6 * g.R1, 0, 0.8 * g.R1), label="$R_1$", offset=0)
    s.dimension(C, (g.R1 + 1.6 * g.R2, 0, 0.8 * g.R2), label="$R_2$", offset=0)
    s.dot(O, "O")
