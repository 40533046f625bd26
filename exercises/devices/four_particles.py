"""The particles of 5/15 and 7/15: four on a chain of light rods from O, along x, y and z."""

from exercises.annotations import AnyAxes, Givens, Scalar, Triple
from exercises.tools import Sketch
from newton_euler import Frame, Point


def places(g: Givens) -> tuple[Triple, ...]:
    return (0, 0, 0), (g.a, 0, 0), (g.a, g.b, 0), (g.a, g.b, g.c)


def masses(g: Givens) -> tuple[Scalar, ...]:
    return g.m1, g.m2, g.m3, g.m4


def rods(g: Givens) -> tuple[Triple, ...]:
    """The vectors from each particle to the next, for the mistake of taking them as positions."""
    return (g.a, 0, 0), (0, g.b, 0), (0, 0, g.c)


def particles(g: Givens) -> tuple[Frame, list[tuple[Scalar, Point]]]:
    """The frame, and a pair (mass, point) for each particle, the one at O first."""
    ground = Frame("ground")
    points = [ground.point(f"P_{n}", *at) for n, at in enumerate(places(g), 1)]
    return ground, list(zip(masses(g), points, strict=True))


def draw(g: Givens, ax: AnyAxes) -> None:
    ground, parts = particles(g)
    s = Sketch(ax, ground, azimuth=-60, elevation=22)
    x, z = ground.i, ground.k
    span, mass = g.a + g.b + g.c, sum(m for m, _ in parts)
    s.axes((0, 0, 0), ground, length=0.5 * span)
    for (_, A), (_, B), name, away in zip(
        parts, parts[1:], "abc", (-0.12 * span * z, -0.12 * span * z, 0.12 * span * x), strict=False
    ):
        s.rod(A, B)
        s.dimension(A, B, label=name, offset=away)
    corners = (-24, -6), (-18, 14), (-22, 8), (-24, 6)
    for n, ((m, P), offset) in enumerate(zip(parts, corners, strict=True), 1):
        s.sphere(P, 0.045 * span * (m / mass) ** (1 / 3))  # all of one density
        s.label(P, f"$m_{n}$", offset=offset, bold=False)
    s.label((0, 0, 0), "O", offset=(-14, 14))
