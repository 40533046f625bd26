"""The bracket of 4/18, 4/19 turns about the horizontal arm EG, which turns about the vertical."""

from collections.abc import Callable

from exercises.annotations import Answers, AnyAxes, Givens, Mistakes, Scalar, Solve, Steps, StepsOf
from exercises.catalogue.proofs.digits import Number
from exercises.devices.moving_frame import seen_in, turning_of
from exercises.tools import Sketch, in_frame, mp, rate, second_rate, terms
from newton_euler import Frame, Point


def arm_and_bracket(g: Givens) -> tuple[Frame, Frame, Frame]:
    """Ground with y up; DEG, about y; the bracket, about x along EG, with its origin at C."""
    ground = Frame("ground")
    arm = ground.rotate("DEG", "y", rate=g.omega_2)
    bracket = arm.rotate("bracket", "x", rate=g.omega_1, origin=arm.point("C", g.c, 0, 0))
    return ground, arm, bracket


def problem_of(
    name: str, out: Callable[[Givens], Scalar]
) -> tuple[Callable[[Givens], tuple[Point, Frame, Frame]], Solve, StepsOf, Solve]:
    """The point as a function of g, b up and ``out(g)`` along from C; solve, steps, prove."""

    def point(g):
        ground, arm, bracket = arm_and_bracket(g)
        return bracket.point(name, 0, g.b, out(g)), ground, arm

    return (
        point,
        lambda g: motion_by_way_of_arm(*point(g)),
        lambda g: motion_steps(*point(g)),
        lambda g: prove(g, name, out(g)),
    )


def motion_by_way_of_arm(P: Point, ground: Frame, arm: Frame) -> Answers:
    """The answers for the point P of the bracket."""
    v, a = P.velocity(ground, via=arm), P.acceleration(ground, via=arm)
    return in_frame(ground, {f"v_{P.name}": v, f"a_{P.name}": a})


def motion_steps(P: Point, ground: Frame, arm: Frame) -> Steps:
    """The motion of P, a point of the bracket, relative to DEG, then the terms of the answers."""
    yield from turning_of(arm, ground, ground, "DEG", "the moving frame, fixed in DEG,")
    yield from seen_in(arm, P, ground, "mm", "DEG", "E")
    v, a = motion_by_way_of_arm(P, ground, arm).values()
    yield from terms(v, f"v_{P.name}", "mm/s", "4.8")
    yield from terms(a, f"a_{P.name}", "mm/s^2", "4.8")


def common_mistakes(P: Point, ground: Frame) -> Mistakes:
    """The mistakes of both problems; here the moving frame is the bracket."""
    v, a = P.velocity(ground), P.acceleration(ground)
    return in_frame(ground, {
        "C_at_rest": {f"v_{P.name}": v.without("origin"), f"a_{P.name}": a.without("origin")},
        # the euler term counted twice
        "coriolis_and_alpha_x_r": {f"a_{P.name}": a.reweighted(euler=2)},
    })  # fmt: skip


def prove(g: Givens, name: str, out: Number) -> Answers:
    """The point goes round the arm, then round y."""

    def seen(t):
        phi = g.omega_1 * t
        y, z = g.b * mp.cos(phi) - out * mp.sin(phi), g.b * mp.sin(phi) + out * mp.cos(phi)
        return [g.c, y, z]

    def place(t):
        theta = g.omega_2 * t
        _, y, z = seen(t)
        return [g.c * mp.cos(theta) + z * mp.sin(theta), y, z * mp.cos(theta) - g.c * mp.sin(theta)]

    found = {"r": seen(0), "v_r": rate(seen), "a_r": second_rate(seen)}
    return {f"v_{name}": rate(place), f"a_{name}": second_rate(place)} | found


def sketch(g: Givens, ax: AnyAxes, a: Scalar) -> tuple[Sketch, Point, Point]:
    """The figure of both problems, with the length ``a`` of BA."""
    ground, arm, bracket = arm_and_bracket(g)
    places = ("E", 0, 0), ("C", g.c, 0), ("G", 1.3 * g.c, 0), ("D", 0, -0.7 * g.c)
    E, C, G, D = (arm.point(name, x, y, 0) for name, x, y in places)
    B, A = bracket.point("B", 0, g.b, 0), bracket.point("A", 0, g.b, a)
    s = Sketch(ax, ground, azimuth=35, elevation=14, up="y")
    s.ground(D, normal=ground.j)
    s.shaft(D, E)
    s.shaft(E, G)
    s.rod(C, B, A)
    s.axes(E, ground, length=0.4 * g.c)
    s.turn(D, ground.j, label=r"$\omega_2$")
    s.turn(G, ground.i, label=r"$\omega_1$")
    s.dimension(E, C, label="c", offset=-0.1 * g.c)
    s.dimension(C, B, label="b")
    for P in (B, D, E, G):
        s.label(P, P.name)
    s.label(A, "A")
    s.label(C, "C", offset=(13, -15))
    return s, B, A
