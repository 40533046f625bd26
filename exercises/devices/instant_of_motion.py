"""A point with known velocity and acceleration at one instant, as in 3/9 to 3/11."""

from collections.abc import Sequence
from typing import Any

from exercises.annotations import AnyAxes, Givens, Number, Scalar
from exercises.tools import Sketch, mp, rate, scaled, size
from newton_euler import Frame, Vector

GROUND = Frame("ground")


def vectors(g: Givens) -> tuple[Vector, Vector]:
    return GROUND.vector(g.v_x, g.v_y, g.v_z), GROUND.vector(g.a_x, g.a_y, g.a_z)


def speed_and_flexure(v: Sequence[Number], a: Sequence[Number]) -> tuple[Number, Number]:
    """Proof: rate of the speed, and rotation of the tangent per length of path."""
    velocity = lambda t: [x + y * t for x, y in zip(v, a, strict=True)]
    tangent = lambda t: scaled(1 / size(velocity(t)), velocity(t))
    return rate(lambda t: size(velocity(t))), size(rate(tangent)) / size(v)


def angle_between(v: Sequence[Number], a: Sequence[Number]) -> Number:
    """Proof: from the sides of the triangle of v, a and their difference."""
    b, c = size(v), size(a)
    third = size([x - y for x, y in zip(v, a, strict=True)])
    return mp.acos((b * b + c * c - third * third) / (2 * b * c))


def figure(ax: AnyAxes, v: Vector, a: Vector, angle: str, **view: Any) -> tuple[Sketch, Scalar]:
    """The path near P with v and a: (sketch, the time in which a changes v by its size)."""
    s = Sketch(ax, v.frame, **view)
    T = v.norm() / a.norm()
    s.path([v * (T * n / 20) + a * (T * n / 20) ** 2 / 2 for n in range(-16, 20)])
    O = (0, 0, 0)
    s.vector(O, v, "$\\mathbf{v}$")
    s.vector(O, a, "$\\mathbf{a}$", kind="acceleration")
    if angle:
        s.arc(O, v, a, label=angle)
    s.dot(O, "P")
    return s, T
