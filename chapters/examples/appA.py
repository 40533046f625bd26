"""Worked examples of Appendix A: the rate of a unit vector, the normal of a triangle, the plane
through three points.
"""

from newton_euler import Frame, Point, Vector, moving
from newton_euler.algebra.scalars import Scalar, SingularError, is_zero, scalar


def turning_unit_vector(theta: Scalar, rate: Scalar) -> tuple[Vector, Vector]:
    """The unit vector e = cos theta i + sin theta j and its rate theta' e_theta, Vectors of the
    ground (App. A, example 1).

    theta, rate : rad from i towards j, and rad/s

    >>> e, e_dot = turning_unit_vector(0.0, 3.0)
    >>> e_dot, e.dot(e_dot)
    (Vector(-0.0, 3.0, 0 in ground), 0.0)
    """
    ground = Frame("ground")
    turning = ground.rotate("turning", "z", moving(theta, rate))
    return turning.i.expressed_in(ground), turning.i.rate(ground).expressed_in(ground)


def triangle(A: Point, B: Point, C: Point) -> tuple[Vector, Vector, Vector]:
    """The unit vectors along AB and AC, and the unit normal in the direction of AB x AC, of three
    Points of one frame (App. A, example 2). Raises :class:`.SingularError` if they lie exactly on
    one line.

    >>> ground = Frame("ground")
    >>> A, B = ground.point("A", 0, 0, 0), ground.point("B", 2.0, 0, 0)
    >>> triangle(A, B, ground.point("C", 0, 5.0, 0))[2]
    Vector(0, 0, 1.0 in ground)
    """
    return (B - A).direction(), (C - A).direction(), _normal(A, B, C).direction()


def plane(A: Point, B: Point, C: Point) -> tuple[Scalar, ...]:
    """(a, b, c, d) of the plane a x + b y + c z + d = 0 through three Points of one frame (App. A,
    example 3); (a, b, c) is AB x AC. With coordinates in m, a, b, c are in m^2 and d in m^3. Raises
    :class:`.SingularError` as :func:`triangle` does.

    >>> ground = Frame("ground")
    >>> plane(ground.point("A", 1, 1, 1), ground.point("B", 4, 5, 6), ground.point("C", 2, 3, 7))
    (14, -13, 2, -3)
    """
    normal = _normal(A, B, C).expressed_in(A.frame)
    return (*normal, -normal.dot(A.position(A.frame)))


def _normal(A, B, C):
    normal = (B - A).cross(C - A)
    if is_zero(scalar(normal.norm())):
        raise SingularError(
            f"{A.name}, {B.name} and {C.name} lie on one line: they have no normal, and many "
            "planes pass through them"
        )
    return normal
