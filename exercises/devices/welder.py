"""The welder of 2/34, 2/35: a bracket with tips D and E, sliding on a plate that turns about A."""

from collections.abc import Callable

from exercises.annotations import AnyAxes, Functions, Givens, Mistakes, Scalar
from exercises.devices.turning_plate import motion, motion_steps, proof, turning
from exercises.tools import Sketch, in_frame
from newton_euler import Frame, Point, moving


def about(
    name: str, side: int
) -> tuple[Callable[[Givens], tuple[Frame, Point]], *Functions, Callable[[Givens], Mistakes]]:
    """The tip as a function of g, solve, steps, prove, draw, mistakes; ``side`` is 1 above A."""
    place = lambda g: (getattr(g, f"x_{name}"), side * getattr(g, f"y_{name}"))
    this_tip = lambda g: tip(g, name, *place(g))

    def prove(g):
        x, y = place(g)
        return proof(name, "plate", lambda t: g.omega * t, lambda t: x + g.u * t, lambda t: y)

    return (
        this_tip,
        lambda g: motion(*this_tip(g)),
        lambda g: motion_steps(*this_tip(g), "in"),
        prove,
        lambda g, ax: draw(g, ax, name, *place(g)),
        lambda g: mistakes(g, name, *place(g)),
    )


def tip(g: Givens, name: str, x: Scalar, y: Scalar) -> tuple[Frame, Point]:
    """Ground, and the tip at x, y from A, moving along i in the plate."""
    ground, plate = turning("plate", g.omega)
    return ground, plate.point(name, moving(x, rate=g.u), y, 0)


def mistakes(g: Givens, name: str, x: Scalar, y: Scalar) -> Mistakes:
    """No Coriolis term; the tip at the level of A; the other tip."""
    ground, P = tip(g, name, x, y)
    return {
        "no_coriolis": in_frame(ground, {f"a_{name}": P.acceleration(ground).without("coriolis")}),
        "horizontal_only": motion(*tip(g, name, x, 0 * y)),
        "other_tip": motion(*tip(g, name, x, -y)),
    }


def draw(g: Givens, ax: AnyAxes, name: str, x: Scalar, y: Scalar) -> None:
    """The figure, with both tips equally far from the level of A."""
    ground, P = tip(g, name, x, y)
    plate, h, side = P.frame, abs(y), y / abs(y)
    A, C, end = (plate.point(*p, 0, 0) for p in (("A", 0 * x), ("C", 0.42 * x), ("end", x)))
    fork, b = 0.75 * x, 0.1 * x
    s = Sketch(ax, ground, plane="xy")
    s.plate([(-0.17 * x, -b, 0), (0.6 * x, -b, 0), (0.6 * x, b, 0), (-0.17 * x, b, 0)],
            shade="light")  # fmt: skip
    s.rod((0.25 * x, 0, 0), (fork, 0, 0))
    s.cylinder((0.33 * x, 0, 0), (0.52 * x, 0, 0), 0.05 * x)
    s.rod((fork, -h, 0), (fork, h, 0))
    for letter, level in (("D", h), ("E", -h)):
        s.rod((fork, level, 0), (x, level, 0))
        s.label((x, level, 0), letter, offset=(9, -9 if level > 0 else 9))
    s.dot(P)
    s.hinge(A)
    s.axes(A, ground, length=0.2 * x, labels=["i", "j", ""])
    s.turn(A, ground.k, label=r"$\omega$")
    s.vector((fork, 0, 0), ground.i, "u")
    s.label(A, "A", offset=(-26, 0))
    s.label(C, "C", offset=(0, 18))
    s.dimension((0, -h, 0), (x, -h, 0), f"$x_{name}$", offset=-0.12 * x)
    s.dimension(end, P, f"$y_{name}$", offset=-0.2 * x * side)
