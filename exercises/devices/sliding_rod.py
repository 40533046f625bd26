"""The rod BE of 2/36 to 2/39 slides along i in a bracket that turns clockwise about A.

omega grows at alpha (clockwise), and u falls at dec, if they are given.
"""

from collections.abc import Callable

from exercises.annotations import Answers, AnyAxes, Functions, Givens, Mistakes, Number, Scalar
from exercises.devices.turning_plate import motion, motion_steps, proof, turning
from exercises.tools import Sketch, in_frame
from newton_euler import Frame, Point, moving


def about(name: str, side: int) -> tuple[Callable[[Givens], tuple[Frame, Point]], *Functions]:
    """The end as a function of g, solve, steps, prove, draw; ``side``: -1 or 1, along i from A."""
    place = lambda g: (side * getattr(g, f"x_{name}"), getattr(g, f"y_{name}"))
    this_end = lambda g: end(g, name, *place(g))
    return (
        this_end,
        lambda g: motion(*this_end(g)),
        lambda g: motion_steps(*this_end(g), "mm"),
        lambda g: prove(g, name, *place(g)),
        lambda g, ax: draw(g, ax, name, *place(g)),
    )


def second_rates(g: Givens) -> tuple[Scalar, Scalar]:
    """The clockwise rate of omega, and that of u."""
    return getattr(g, "alpha", 0), -getattr(g, "dec", 0)


def end(g: Givens, name: str, x: Scalar, y: Scalar) -> tuple[Frame, Point]:
    alpha, a_r = second_rates(g)
    ground, bracket = turning("bracket", -g.omega, -alpha)
    return ground, bracket.point(name, moving(x, rate=g.u, acceleration=a_r), y, 0)


def prove(g: Givens, name: str, x: Number, y: Number) -> Answers:
    """Proof by the explicit path of the end."""
    alpha, a_r = second_rates(g)
    return proof(
        name,
        "bracket",
        lambda t: -g.omega * t - alpha * t**2 / 2,
        lambda t: x + g.u * t + a_r * t**2 / 2,
        lambda t: y,
    )


def without(ground: Frame, P: Point, *names: str) -> Answers:
    """The answer for the acceleration of P without these terms."""
    return in_frame(ground, {f"a_{P.name}": P.acceleration(ground).without(*names)})


def common_mistakes(g: Givens, scene: Callable[[Givens], tuple[Frame, Point]], x: str) -> Mistakes:
    """The mistakes of 2/36 and 2/39; ``scene(g)`` is the end, ``x`` names its distance from A."""
    return {
        "counterclockwise": motion(*scene(g.but(omega=-g.omega))),
        "no_coriolis": without(*scene(g), "coriolis"),
        "other_end": motion(*scene(g.but(**{x: -getattr(g, x)}))),
    }


def draw(g: Givens, ax: AnyAxes, name: str, x: Scalar, y: Scalar) -> None:
    """The figure; the rod extends equally far on both sides of A. A wider arc is alpha."""
    ground, P = end(g, name, x, y)
    bracket, side, far = P.frame, x / abs(x), abs(x)
    w, A = 0.12 * far, bracket.point("A", 0 * x, 0, 0)
    C, D = (bracket.point(n, a * far, y, 0) for n, a in (("C", -0.5), ("D", 0.5)))
    s = Sketch(ax, ground, plane="xy")
    foot = 0.6 * w
    s.plate([(-foot, -foot, 0), (foot, -foot, 0), (0.62 * far, y, 0), (-0.62 * far, y, 0)],
            shade="light")  # fmt: skip
    s.rod((-far, y, 0), (far, y, 0))
    for G, a in ((C, -0.5), (D, 0.5)):
        s.cylinder((a * far - w, y, 0), (a * far + w, y, 0), 0.5 * w)
        s.label(G, G.name, offset=(0, 17))
    for letter, a in (("B", -far), ("E", far)):
        s.label((a, y, 0), letter, offset=(0, -13))
    s.dot(P)
    s.hinge(A)
    s.axes(A, ground, labels=["i", "j", ""])
    s.turn(A, -ground.k, label=r"$\omega$")
    s.vector((far, y, 0), ground.i, "u")
    if hasattr(g, "alpha"):
        s.turn(A, -ground.k, label=r"$\alpha$", radius=0.45 * far)
    if hasattr(g, "dec"):
        s.vector((0.9 * far, y - 0.3 * far, 0), -ground.i, "d", kind="acceleration")
    s.label(A, "A", offset=(-4, -22))
    s.line((0.45 * x, 0, 0), (0.9 * x, 0, 0))
    s.dimension((0, y, 0), P, f"$x_{name}$", offset=0.4 * far * side)
    s.dimension((0.9 * x, 0, 0), (0.9 * x, y, 0), f"$y_{name}$", offset=0.1 * x)
