"""The slotted arm of 2/24, 2/25, turning about O, with the pin P of a crank CP in it; OC = CP."""

from collections.abc import Sequence

from exercises.annotations import AnyAxes, Givens, Number, Path
from exercises.tools import at_angle, on_ground, plus, rot, times
from newton_euler import cos, moving, sin
from newton_euler.algebra import Moving


def turning(g: Givens) -> tuple[Moving, Moving]:
    """The angle of the arm and the distance OP, with their rates."""
    theta = moving(g.theta, rate=g.omega)
    return theta, 2 * g.b * cos(theta)


def crank(g: Givens) -> Path:
    """Proof: P over time; the angle at the centre is twice that at the circumference."""
    return lambda t: plus([g.b, 0, 0], at_angle(g.b, 2 * (g.theta + g.omega * t)))


def in_arm(g: Givens, vector: list[Number], t: Number = 0) -> list[Number]:
    """Proof: components along the arm and across it."""
    return times(rot("z", -g.theta - g.omega * t), vector)


def sketch(g: Givens, ax: AnyAxes, labels: Sequence[str]) -> None:
    """The figure of both problems; ``labels``: of the axes along the arm."""
    ground, s = on_ground(ax, plane="xy")
    arm = ground.rotate("arm", "z", g.theta)
    O, C = ground.point("O", 0, 0, 0), ground.point("C", g.b, 0, 0)
    P = arm.point("P", 2 * g.b * cos(g.theta), 0, 0)
    end = arm.point("end", 2.35 * g.b, 0, 0)
    s.path(s.around(C, O, ground.k), style="dashed")
    s.line(O, C)
    s.rod(O, end)
    s.rod(C, P)
    s.hinge(O)
    s.hinge(C)
    s.arc(O, C, P, label=r"$\theta$")
    s.swing(O, end, ground.k, label=r"$\omega$")
    s.dimension(O, C, label="b", offset=-0.25 * g.b)
    right = ground.vector(sin(2 * g.theta), -cos(2 * g.theta), 0)  # direction from C to P
    s.label((C.position(ground) + P.position(ground)) / 2, "$b$", offset=right, bold=False)
    s.axes(P, arm, length=0.4 * g.b, labels=[*labels, ""])
    s.label(O, "O", offset=(-12, 4))
    s.label(C, "C", offset=(10, -12))
    s.dot(P, "P", offset=ground.vector(sin(g.theta), -cos(g.theta), 0))
