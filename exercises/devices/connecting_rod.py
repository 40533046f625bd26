"""A connecting rod with parallel axes AA', GG' and BB', along z."""

from collections.abc import Sequence

from exercises.annotations import AnyAxes, Number, Scalar
from exercises.tools import Sketch, mp, proofs
from newton_euler import Frame, Inertia, Point, bodies

ROD = Frame("rod")


def about_A(mass: Scalar, moment: Scalar, r_a: Scalar, r_b: Scalar) -> tuple[Inertia, Point, Point]:
    """The :class:`Inertia` at A, with only the moment about AA' known, and G and B."""
    G = ROD.point("G", r_a, 0, 0)
    A = bodies.Inertia(ROD, (0, 0, moment), mass=mass, centre=G, tolerance=None)
    return A, G, ROD.point("B", r_a + r_b, 0, 0)


def two_masses(moment_per_mass: Number, r_a: Number) -> list[Number]:
    """Proof: distances from A of two mass points, k from G, with the moment about AA'."""
    places = lambda k: [r_a - k, r_a + k]
    missing = lambda k: mean_square(places(k)) - moment_per_mass
    k = proofs.root(missing, 0, 2 * mp.sqrt(moment_per_mass))
    return places(k)


def mean_square(distances: Sequence[Number]) -> Number:
    return sum(x**2 for x in distances) / len(distances)


def figure(ax: AnyAxes, r_a: Scalar, r_b: Scalar) -> tuple[Sketch, Scalar]:
    """Side view: the axes as vertical lines."""
    s = Sketch(ax, ROD, plane="xz")
    length = r_a + r_b
    big, small, high = 0.16 * length, 0.1 * length, 0.13 * length

    def block(left, right, height):
        s.plate([(x, 0, z) for x, z in
                 ((left, -height), (right, -height), (right, height), (left, height))])  # fmt: skip

    block(0, length, 0.35 * high)
    block(-big, big, high)
    block(length - small, length + small, high)
    for name, x in ("A", 0), ("G", r_a), ("B", length):
        ends = (x, 0, -1.9 * high), (x, 0, 1.9 * high)
        s.line(*ends, style="centre")
        s.label(ends[1], name, offset=(-9, -6))
        s.label(ends[0], f"{name}'", offset=(-9, 6))
    return s, 2.4 * high
