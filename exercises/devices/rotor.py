"""A body on a shaft in two bearings (9/1 to 9/6): H, its rate, forces, balance; x from A to B."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from exercises.annotations import Answers, AnyAxes, Follows, Givens, Scalar, Solve, Steps, StepsOf
from exercises.catalogue.proofs.digits import Number, Points
from exercises.tools import Sketch, Step, in_frame, mpf, proofs, rate, rot, size, terms
from newton_euler import Body, Frame, Point, composite, dynamics
from newton_euler.applications import balance, reactions
from newton_euler.applications.rotors import Reactions

SMALL = mpf(10) ** -25  # a sum over mass points below this, with terms of about 1, is zero


@dataclass(frozen=True)
class Rotor:
    """A body, the bearings and the point O of the angular momentum, fixed in the shaft's frame."""

    ground: Frame
    shaft: Frame
    body: Body
    O: Point
    A: Point
    B: Point


def turning_shaft(g: Givens) -> tuple[Frame, Frame]:
    """Ground, and the shaft that turns in it about x."""
    ground = Frame("ground")
    return ground, ground.rotate("shaft", "x", rate=g.omega)


def in_bearings(shaft: Frame, parts: Iterable[Body], a: Scalar, b: Scalar) -> Rotor:
    """The parts as one body along the shaft's axes, bearings at x = a and x = b, about O at 0."""
    body = composite("rotor", parts, frame=shaft)
    A, B = shaft.point("A", a, 0, 0), shaft.point("B", b, 0, 0)
    return Rotor(shaft.tree[0], shaft, body, shaft.point("O", 0, 0, 0), A, B)


def forces(r: Rotor) -> Reactions:
    return reactions(r.body, r.A, r.B, r.ground, about=r.O)


def answers(r: Rotor) -> Answers:
    H, found = dynamics.angular_momentum(r.body, r.ground, r.O).expressed_in(r.shaft), forces(r)
    return in_frame(r.shaft, {
        "H_O": H,
        "Hdot_O": H.rate(r.ground),
        "F_A": found.A,
        "F_B": found.B,
        "balance": lambda: balance(r.body, r.A, r.B, about=r.O).state,
    })  # fmt: skip


# -- steps


def principal_steps(body: Body, *axes: tuple[str, str, str]) -> Steps:
    """The relevant moments of inertia about the centre; ``axes``: (key, body axis, description)."""
    for key, axis, which in axes:
        yield Step(key, body.inertia.moment(axis), "kg*m^2", f"moment of inertia {which}", "7.6")


def shaft_steps(
    r: Rotor, products: str = "xy", from_principal: bool = False, particles: bool = False
) -> Steps:
    """The moment and the non-zero ``products`` of inertia in H_O, and by which formula."""
    found = ("7.4", "") if from_principal else ("7.2", "7.9" if particles else "7.10")
    added = "the sum of m*{}*{}" if particles else "the integral of {}*{}*dm"
    I = r.body.about(r.O, r.shaft)
    yield Step("I_xx", I.moments[0], "kg*m^2", "moment of inertia about the axis of the shaft",
               *found)  # fmt: skip
    for name in products.split():
        product = {"xy": I.products[0], "xz": I.products[2]}[name]
        means = f"product of inertia about O, {added.format(*name)}"
        yield Step(f"I_{name}", product, "kg*m^2", means, *found)


def force_steps(r: Rotor) -> Steps:
    """Steps for G off the axis: its acceleration, and the terms of each bearing force."""
    a_G = r.body.centre.acceleration(r.ground).expressed_in(r.shaft)
    yield Step("a_G", a_G, "m/s^2", "acceleration of the centre of mass", "4.8", "4.18")
    for key, force in ("F_A", forces(r).A), ("F_B", forces(r).B):
        yield from terms(force.expressed_in(r.shaft), key, "N", "9.5", "9.9")


# -- a later answer from an earlier one


def following(rotor_of: Callable[[Givens], Rotor]) -> Follows:
    """``follows`` of a problem whose :class:`Rotor` is ``rotor_of(g)``."""
    Hdot_O = lambda g, H_O: (H_O.frame.i * g.omega).cross(H_O)

    def F_A(g, Hdot_O):
        r = rotor_of(g)
        right, axes = answers(r), Hdot_O.frame
        off = Hdot_O - axes.vector(*right["Hdot_O"])
        return axes.vector(*right["F_A"]) + axes.i.cross(off) / (r.B - r.A).x

    def F_B(g, F_A):
        right, axes = answers(rotor_of(g)), F_A.frame
        return axes.vector(*right["F_A"]) + axes.vector(*right["F_B"]) - F_A

    def balanced(g, Hdot_O, F_A, F_B):
        """Forces written in few digits leave a sum that is not quite zero."""
        near = (F_A.norm() + F_B.norm()) / 100
        small = answers(rotor_of(g))["H_O"].norm() * g.omega / 10**9
        return state((F_A + F_B).norm() <= near, Hdot_O.norm() <= small)

    return {"Hdot_O": Hdot_O, "F_A": F_A, "F_B": F_B, "balance": balanced}


def problem_of(
    rotor_of: Callable[[Givens], Rotor],
    *axes: tuple[str, str, str],
    products: str = "xy",
    off_axis: bool = False,
    particles: bool = False,
) -> tuple[Solve, StepsOf, Follows]:
    """``solve``, ``steps`` and ``follows`` of a problem whose :class:`Rotor` is ``rotor_of(g)``.

    axes : for :func:`principal_steps`, of a body of one part
    off_axis : whether its centre of mass is off the axis
    """

    def steps(g):
        r = rotor_of(g)
        yield from principal_steps(r.body.parts[0], *axes)
        yield from shaft_steps(r, products, bool(axes), particles)
        if off_axis:
            yield from force_steps(r)

    return (lambda g: answers(rotor_of(g))), steps, following(rotor_of)


# -- mistakes


def with_inertia(r: Rotor, moment: Scalar = 1, product: Scalar = 1) -> Answers:
    """The answers with wrong factors on the shaft's moment of inertia and on the products."""
    right, found = answers(r), forces(r)
    H, change = right["H_O"], product - 1
    # added, not reweighted, so that zero remains a formula in the symbols
    return in_frame(r.shaft, {
        "H_O": r.shaft.vector(moment * H.x, product * H.y, product * H.z),
        "Hdot_O": right["Hdot_O"] + right["Hdot_O"] * change,
        "F_A": found.A + found.A.terms["dynamic"] * change,
        "F_B": found.B + found.B.terms["dynamic"] * change,
    })  # fmt: skip


def only(answers: Answers, *keys: str) -> Answers:
    """These answers; all but the word by default."""
    return {key: answers[key] for key in keys or ("H_O", "Hdot_O", "F_A", "F_B")}


def pure_couple(r: Rotor) -> Answers:
    """The mistake of bearing forces without m a_G."""
    found = forces(r)
    wrong = {"F_A": found.A.without("static"), "F_B": found.B.without("static")}
    return in_frame(r.shaft, wrong)


# -- proof


def prove(
    g: Givens, points: Points, a: Number, b: Number, extra: Iterable[str] = ("I_xx", "I_xy")
) -> Answers:
    """The answers from rotating mass points, pairs (mass, place in the shaft): their angular
    momentum about O, its rate, and the moments that the motion needs about the bearings. A force
    has no moment about its own bearing, so each follows from the moment about the other. ``extra``
    names steps to return too.
    """
    carried = proofs.carried(points, lambda t: rot("x", g.omega * t))
    momentum = lambda t: proofs.angular_momentum(1, carried, t=t)
    _, y, z = proofs.moment_needed(1, carried, (a, 0, 0))
    F_B = [0, z / (b - a), -y / (b - a)]
    _, y, z = proofs.moment_needed(1, carried, (b, 0, 0))
    F_A = [0, z / (a - b), -y / (a - b)]
    H, Hdot, force = momentum(0), rate(momentum), proofs.force_needed(1, carried)
    rests = size(force) < SMALL * g.omega**2 * sum(m * size(place) for m, place in points)
    steady = size(Hdot) < SMALL * g.omega * size(H)
    x_y_z = [(m, *place) for m, place in points]
    steps = {
        "I_xx": sum(m * (y * y + z * z) for m, _, y, z in x_y_z),
        "I_xy": sum(m * x * y for m, x, y, _ in x_y_z),
        "I_xz": sum(m * x * z for m, x, _, z in x_y_z),
        "a_G": proofs.scaled(1 / sum(m for m, _ in points), force),
    }
    return {
        "H_O": H,
        "Hdot_O": Hdot,
        "F_A": F_A,
        "F_B": F_B,
        "balance": lambda: state(rests, steady),
    } | {key: steps[key] for key in extra}


def state(static: bool, dynamic: bool) -> str:
    """The answer on the balance."""
    if static and dynamic:
        return "both"
    return "static" if static else "dynamic" if dynamic else "neither"


# -- figure


def sketch(ax: AnyAxes, r: Rotor, azimuth: float = -28, elevation: float = 18) -> Sketch:
    """The shaft in its bearings with the rate omega."""
    s = Sketch(ax, r.shaft, up="y", azimuth=azimuth, elevation=elevation)
    a, b = (P.position(r.shaft).x for P in (r.A, r.B))
    out = 0.14 * (b - a)
    s.shaft((a - out, 0, 0), (b + 1.4 * out, 0, 0))
    for P in (r.A, r.B):
        s.hinge(P, axis=r.shaft.i)
        s.label(P, P.name)
    s.turn((b + 0.8 * out, 0, 0), r.shaft.i, label=r"$\omega$")
    return s
