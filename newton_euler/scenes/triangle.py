"""Three points: the directions of the sides, the normal, and the plane through them (App. A, examples 2 and 3)."""

from ..scalars import SingularError, is_zero, scalar


def triangle(A, B, C):
    """The unit vectors along AB and AC, and the unit normal in the sense of AB x AC, of three Points of one frame.

    Raises :class:`~newton_euler.scalars.SingularError` if the points lie on one line (exactly), so that no normal exists.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> A, B, C = ground.point("A", 0, 0, 0), ground.point("B", 2.0, 0, 0), ground.point("C", 0, 5.0, 0)
    >>> triangle(A, B, C)[2]
    Vector(0, 0, 1.0 in ground)
    """
    normal = _normal(A, B, C)
    return (B - A).direction(), (C - A).direction(), normal.direction()


def plane(A, B, C):
    """(a, b, c, d) of the plane a x + b y + c z + d = 0 through three Points of one frame; (a, b, c) is AB x AC.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> plane(ground.point("A", 1, 1, 1), ground.point("B", 4, 5, 6), ground.point("C", 2, 3, 7))
    (14, -13, 2, -3)
    """
    normal = _normal(A, B, C).expressed_in(A.frame)
    return (*normal, -normal.dot(A.position(A.frame)))


def _normal(A, B, C):
    normal = (B - A).cross(C - A)
    if is_zero(scalar(normal.norm())):
        raise SingularError(f"{A.name}, {B.name} and {C.name} lie on one line: they have no normal, and many planes pass through them")
    return normal
