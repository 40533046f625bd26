"""Two blocks on one rope over pulleys without mass or friction, 6/5 to 6/8: in the x, y plane, y
up.

The rope pulls each block along a line toward the pulley.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from exercises.annotations import AnyAxes, Givens, Number, Path, Scalar, Steps
from exercises.tools import Step, minus, on_ground, rate, root
from newton_euler import Frame, cos, pi, sin, tan
from newton_euler.algebra.vectors import Vector
from newton_euler.dynamics import mass_from_weight


@dataclass
class Block:
    """A block that the rope pulls along ``line``; ``on_face``: of a wedge."""

    name: str
    W: Scalar
    m: Scalar
    line: Vector
    on_face: bool = False
    pulls: int = 1  # parts of the rope that pull on it
    runs: int = 1  # parts that shorten as it moves along its line

    @property
    def W_t(self) -> Scalar:
        """The component of its weight against the pull of the rope."""
        return self.W * self.line.y


def hanging(g: Givens, name: str, W: Scalar, parts: int = 1) -> Block:
    """A block of this weight on this many parts of the rope."""
    return Block(name, W, mass_from_weight(W, g.g), Frame("ground").j, False, parts, parts)


def on_face(g: Givens, name: str, W: Scalar, angle: Scalar, toward: int = 1) -> Block:
    """On a smooth face that rises at ``angle``, to the right, or with ``toward`` -1 to the left."""
    line = Frame("ground").vector(toward * cos(angle), sin(angle), 0)
    return Block(name, W, mass_from_weight(W, g.g), line, on_face=True)


class Motion(NamedTuple):
    """Accelerations of two blocks along the pull of the rope, and its tension."""

    first: Scalar
    second: Scalar
    T: Scalar


def motion(A: Block, B: Block) -> Motion:
    """The :class:`Motion` of A and B: pulls*T - W_t = m*a for each, and a rope of fixed length."""
    F, M = without_tension(A, B)
    a = F / M
    T = (A.W_t + A.m * (B.runs * a)) / A.pulls
    return Motion(B.runs * a, -A.runs * a, T)


def without_tension(A: Block, B: Block) -> tuple[Scalar, Scalar]:
    """(F, M): net force and effective mass without T; a_A = B.runs F/M and a_B = -A.runs F/M."""
    F = A.pulls * B.W_t - B.pulls * A.W_t
    return F, A.m * (B.runs * B.pulls) + B.m * (A.runs * A.pulls)


def block_steps(A: Block, B: Block, laws: str) -> Steps:
    """The masses, the components of the weights along the rope, and the equation of motion after T
    is eliminated from ``laws``, the equations in words, for the acceleration of ``A`` toward its
    pulley.
    """
    for b in sorted((A, B), key=lambda b: b.name):
        yield Step(f"m_{b.name}", b.m, "slug", f"mass of {b.name}")
    for b in (A, B):
        if b.on_face:
            means = f"part of the weight of {b.name} down its face"
            yield Step(f"W_{b.name}t", b.W_t, "lb", means, "6.1", "6.3")
    F, M = without_tension(A, B)
    means = f"force that is left when T is eliminated from the equations of motion {laws}"
    yield Step("F", F, "lb", means, "6.1", "6.4")
    yield Step("M", M, "slug", f"mass that it accelerates: F = M*a_{A.name}", "6.1", "6.4")


def by_energy(
    g: Givens, W_A: Number, W_B: Number, places: Sequence[Path], reach: Number
) -> tuple[Number, Number]:
    """Proof: the second rate of the length of rope at B, and its tension, from the energy.

    places : functions of the displacement s of B away from its pulley: positions of A and B
    reach : an upper bound of the second rate, which must exceed a millionth of it
    """

    def gain(W, place, a):
        """The gain in energy of a block after unit time, s = a t^2/2 from rest."""
        moved = lambda t: place(a * t**2 / 2)
        up = minus(moved(1), moved(0))[1]
        return W / g.g * sum(v**2 for v in rate(moved, 1)) / 2 + W * up

    of_both = lambda a: gain(W_A, places[0], a) + gain(W_B, places[1], a)
    a = root(of_both, reach / 10**6, reach)
    return a, -gain(W_B, places[1], a) / (a / 2)  # B's loss of energy is its work against the rope


def draw_wedge(
    ax: AnyAxes, left: tuple[Scalar, str], right: tuple[Scalar, str] | None = None
) -> None:
    """A wedge with A on its left, B on its right face or hanging; angles with their labels."""
    ground, s = on_ground(ax, plane="xy")
    height, half, long = 0.55, 0.09, 0.13  # height of the wedge, half sizes of a block
    top, foot = (0, 0, 0), (-height / tan(left[0]), -height, 0)
    heel = (height / tan(right[0]) if right else 0, -height, 0)
    s.plate([top, foot, heel], shade="light")
    s.road([(foot[0] - half, -height, 0), (heel[0] + 3 * half, -height, 0)])

    def block(name, angle, run, side=1, thick=2):
        """A block with its middle at ``run`` from the top; returns the rope's end."""
        face = ground.rotate(f"line of {name}", "z", angle)
        place = face.point(name, -run, side * half, 0)
        s.box(place, face, (2 * long, thick * half, 2 * half))
        s.label(place, name, offset=(0, 0))
        return face.point("end", long - run, side * half, 0)

    A = block("A", left[0], 0.5 * height / sin(left[0]))
    if right:
        B = block("B", pi(right[0]) - right[0], 0.55 * height / sin(right[0]), side=-1)
    else:
        B = block("B", pi(left[0]) / 2, 0.6 * height, side=-1, thick=1.3)
    wheel = s.pulley(top, ground.k, half)  # so that the rope is parallel to the faces
    s.cable(A, wheel, B, turns=[-1])
    s.arc(foot, heel, top, label=left[1])
    if right:
        s.arc(heel, top, foot, label=right[1])
