"""The cars of 2/30 to 2/32, on curves that bend apart: the motion of B as seen from A.

``solve``, ``steps``, ``prove`` and ``draw`` are those of 2/31 and 2/32. The speed of A grows at c_A
and that of B falls at c_B, if they are given.
"""

from collections.abc import Callable

from exercises.annotations import Answers, AnyAxes, Givens, Scalar, Steps
from exercises.tools import Sketch, Step, minus, mp, proofs, rate, rot, second_rate, times
from newton_euler import Frame, Point, Vector, cos, moving, sin


def rates(g: Givens) -> tuple[Scalar, Scalar]:
    """The rates of the speeds of A and B."""
    return getattr(g, "c_A", 0), -getattr(g, "c_B", 0)


def cars(g: Givens) -> tuple[Frame, Frame, Point]:
    """Ground, at the instant parallel to car A; the frame of car A; B."""
    ground, (a_A, a_B) = Frame("ground"), rates(g)
    # both turn counterclockwise: each car has the centre of its curve on its left
    left = ground.point("centre of A's curve", -g.R, 0, 0)
    right = ground.point("centre of B's curve", g.x + g.R, 0, 0)
    first = ground.rotate("curve of A", "z", 0, g.v / g.R, a_A / g.R, origin=left)
    second = ground.rotate("curve of B", "z", 0, g.v / g.R, a_B / g.R, origin=right)
    car = first.translate("car A", first.point("A", g.R, 0, 0))
    return ground, car, second.point("B", -g.R, 0, 0)


def place(ground: Frame, car: Frame, B: Point, seen: Vector | None = None) -> Point:
    """A point of car A at the position of B, moving in the car at the velocity ``seen``, if any."""
    r = B.position(car)
    if seen is None:
        return car.point("Q", *r)
    rates = seen.components(car)
    return car.point("Q", *(moving(x, rate=v) for x, v in zip(r, rates, strict=True)))


def seen_velocity(
    ground: Frame, car: Frame, B: Point, change: Callable[[Vector], Vector] = lambda v: v
) -> Vector:
    """v_B - (v_A + omega x r), (2.24); ``change`` falsifies the sum in brackets."""
    v = place(ground, car, B).velocity(ground)
    return B.velocity(ground).expressed_in(ground) - change(v)


def seen_acceleration(
    ground: Frame, car: Frame, B: Point, *missing: str, seen: Vector | None = None
) -> Vector:
    """a_B - (a_A + alpha x r + 2 omega x v_rel + omega x (omega x r)), (2.25), without the missing
    terms of the sum in brackets; ``seen``: a wrong relative velocity.
    """
    v_rel = seen_velocity(ground, car, B) if seen is None else seen
    a = place(ground, car, B, v_rel).acceleration(ground)
    return B.acceleration(ground).expressed_in(ground) - a.without(*missing)


def solve(g: Givens) -> Answers:
    return {"a_rel": seen_acceleration(*cars(g))}


def velocity_steps(ground: Frame, car: Frame, B: Point) -> Steps:
    """The quantities in (2.24)."""
    v = place(ground, car, B).velocity(ground).expressed_in(ground)
    omega = car.angular_velocity(ground)
    yield Step("omega_A", omega, "rad/s", "angular velocity of the car A, v/R", "2.8", "2.19")
    yield Step("r", B.position(car), "m", "position of B in the car A", "2.10", "2.23")
    yield Step("v_A", v.terms["origin"], "m/s", "velocity of A in the ground", "2.3", "2.4")
    yield Step("v_B", B.velocity(ground), "m/s", "velocity of B in the ground", "2.3", "2.4")
    yield Step("v_rotation", v.terms["rotation"], "m/s", "the term omega x r", "2.10", "2.24")


def steps(g: Givens) -> Steps:
    """The quantities in (2.25)."""
    ground, car, B = cars(g)
    yield from velocity_steps(ground, car, B)
    v_rel = seen_velocity(ground, car, B)
    formula = r"$\mathbf{v}_B - \mathbf{v}_A - \boldsymbol{\omega}\times\mathbf{r}$"
    means = f"velocity of B as seen from the car A, {formula}"
    yield Step("v_rel", v_rel, "m/s", means, "2.10", "2.24")
    terms = place(ground, car, B, v_rel).acceleration(ground).expressed_in(ground).terms
    alpha = car.angular_acceleration(ground)
    yield Step("alpha_A", alpha, "rad/s^2", "angular acceleration of the car A", "2.8")
    means = "acceleration of {} in the ground, tangential and normal"
    yield Step("a_A", terms["origin"], "m/s^2", means.format("A"), "2.3", "2.14", of_givens=True)
    a_B = B.acceleration(ground).expressed_in(ground)
    yield Step("a_B", a_B, "m/s^2", means.format("B"), "2.3", "2.14", of_givens=True)
    for name, means in (
        ("euler", "the term alpha x r"),
        ("coriolis", r"the Coriolis term $2\boldsymbol{\omega}\times\mathbf{v}_\text{rel}$"),
        ("centripetal", "the term omega x (omega x r)"),
    ):
        yield Step(f"a_{name}", terms[name], "m/s^2", means, "2.10", "2.25")


def proved_velocities(g: Givens) -> Answers:
    """Proof: what concerns the velocities, by :func:`prove`."""
    found = prove(g)
    return {key: found[key] for key in ("v_rel", "omega_A", "r", "v_A", "v_B")}


def prove(g: Givens) -> Answers:
    """Both cars over time, and the rates of B's coordinates along the turning axes of A."""
    angle = lambda a: lambda t: (g.v * t + a * t**2 / 2) / g.R

    def on_circle(centre, phi, side):
        return lambda t: [centre + side * g.R * mp.cos(phi(t)), side * g.R * mp.sin(phi(t)), 0]

    phi, of_B = map(angle, rates(g))
    A, B = on_circle(-g.R, phi, 1), on_circle(g.x + g.R, of_B, -1)
    seen = lambda t: times(proofs.transposed(rot("z", phi(t))), minus(B(t), A(t)))
    turned = lambda t: rot("z", phi(t))
    return {
        "a_rel": second_rate(seen),
        "alpha_A": proofs.angular_acceleration(turned),
        "a_A": second_rate(A),
        "a_B": second_rate(B),
        "v_rel": rate(seen),
        "omega_A": proofs.angular_velocity(turned),
        "r": seen(0),
        "v_A": rate(A),
        "v_B": rate(B),
    }


def draw(g: Givens, ax: AnyAxes) -> None:
    ground, _, _ = cars(g)
    s = Sketch(ax, ground, plane="xy")
    far, A, B = 1.3 * g.x / (g.R + 0.3 * g.x), (0, 0, 0), (g.x, 0, 0)
    angles = [far * n / 20 for n in range(-20, 21)]
    s.path([(g.R * cos(p) - g.R, g.R * sin(p), 0) for p in angles])
    s.path([(g.x + g.R - g.R * cos(p), g.R * sin(p), 0) for p in angles])
    long, wide = 0.12 * g.x, 0.05 * g.x
    for x, side in ((0, -1), (g.x, 1)):
        s.plate([(x - wide, -long, 0), (x + wide, -long, 0), (x + wide, long, 0),
                 (x - wide, long, 0)])  # fmt: skip
        s.line((x + side * wide, 0, 0), (x + side * 0.9 * g.x, 0, 0), style="centre")
        s.label((x + side * 0.5 * g.x, 0, 0), "R", offset=(0, 9), bold=False)
    s.vector((0, long, 0), ground.j, "v")
    s.vector((g.x, -long, 0), -ground.j, "v")
    s.dimension(A, B, label="x", offset=0)
    s.axes((-0.8 * g.x, -g.x, 0), ground, labels=["i", "j", ""])
    s.label(A, "A", offset=(-14, -12))
    s.label(B, "B", offset=(14, 12))
    if hasattr(g, "c_A"):
        s.vector((-2 * long, long, 0), ground.j * g.c_A, "$c_A$", kind="acceleration")
        s.vector((g.x + 2 * long, long, 0), ground.j * g.c_B, "$c_B$", kind="acceleration")
