"""A flat body in a vertical plane, hung from a pin and a cable, at the instant the cable snaps: 8/1
and 8/2.

The pin is the origin of the ground, x to the right and y up. A ``shape`` makes the body in a frame
that turns about the pin.
"""

from collections.abc import Callable, Sequence
from typing import TypeAlias

from exercises.annotations import Givens, Number, Path, Points, Scalar, Steps
from exercises.tools import Step, force_needed, kinetic_energy, let_go, mean, rot, times
from newton_euler import Body, Frame, Vector, equations_of_motion, solve_linear
from newton_euler.algebra import Solution
from newton_euler.dynamics import mass_from_weight, reaction, weight

Shape: TypeAlias = Callable[[Frame], Body]


def turned(alpha: Scalar) -> tuple[Frame, Frame]:
    """The ground, and the frame of the body, at rest at the instant."""
    ground = Frame("ground")
    return ground, ground.rotate("body", "z", acceleration=alpha)


def acceleration_of(place: Sequence[Scalar], alpha: Scalar) -> Vector:
    """Acceleration in the ground of a point of the body."""
    ground, frame = turned(alpha)
    return frame.point("P", *place).acceleration(ground).expressed_in(ground)


def mass(g: Givens) -> Scalar:
    return mass_from_weight(g.W, g.g)


def falls(g: Givens, shape: Shape) -> Solution:
    """alpha about z, and the force R_x, R_y of the pin: a solution of ``solve_linear``."""

    def laws(alpha, R_x, R_y):
        ground, frame = turned(alpha)
        body = shape(frame)
        forces = {
            "weight": (weight(body, ground.j, g.g), body.centre),
            "pin": (ground.vector(R_x, R_y, 0), ground),
        }
        return equations_of_motion(body, forces, ground, about=ground)

    return solve_linear(laws)


def moment_of_weight(g: Givens, shape: Shape) -> Scalar:
    """The moment of the weight about z through the pin."""
    ground = Frame("ground")
    body = shape(ground)
    return body.centre.position(ground).cross(weight(body, ground.j, g.g)).z


def pin_force(g: Givens, shape: Shape, alpha: Scalar) -> Vector:
    """The force of the pin on the body for this ``alpha``."""
    ground, frame = turned(alpha)
    body = shape(frame)
    a_G = body.centre.acceleration(ground).expressed_in(ground)
    return reaction(body.mass, a_G, weight=weight(body, ground.j, g.g))


def fall_steps(g: Givens, shape: Shape, pin: str) -> Steps:
    """The steps to alpha and to the force of the pin, whose letter is ``pin``."""
    ground, frame = turned(falls(g, shape).alpha)
    body = shape(frame)
    I, a_G = body.about(ground.origin).moments[2], body.centre.acceleration(ground)
    yield Step("m", body.mass, "slug", "mass, W/g", "6.1")
    yield Step(f"I_{pin}", I, "slug*ft^2", f"moment of inertia about z through {pin}", "8.5")
    yield Step(f"M_{pin}", moment_of_weight(g, shape), "lb*ft",
               f"moment of the weight about z through {pin}", "8.1", "8.7")  # fmt: skip
    yield Step("a_G", a_G.expressed_in(ground), "ft/s^2", "acceleration of the centre of mass",
               "4.8", "4.18")  # fmt: skip


def by_energy(
    g: Givens, points: Points, *places: Sequence[Number]
) -> tuple[Number, list[Number], *tuple[Path, ...]]:
    """Proof: alpha by energy, the pin force by momentum of ``points``, and ``places`` over time."""

    def energy(q, t):
        motion = lambda t: [(share, times(rot("z", q(t)), r)) for share, r in points]
        height = sum(share * r[1] for share, r in motion(t))
        return kinetic_energy(g.W / g.g, motion, t) + g.W * height

    alpha = let_go(energy)
    moves = lambda r: lambda t: times(rot("z", alpha * t**2 / 2), r)
    motion = lambda t: [(share, moves(r)(t)) for share, r in points]
    F_x, F_y, _ = force_needed(g.W / g.g, motion)
    return alpha, [F_x, F_y + g.W, 0], *map(moves, places)


def sums(g: Givens, points: Points, pin: str) -> dict[str, Number]:
    """Proof: the steps, as sums over the mass points."""
    return {
        f"I_{pin}": g.W / g.g * mean(lambda r: r[0] ** 2 + r[1] ** 2, points),
        f"M_{pin}": mean(lambda r: r[0] * -g.W, points),
    }
