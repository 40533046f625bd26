"""Worked examples of chapters 5 and 7, rigid bodies: a thin rod, three rods, a machine part of
sheet metal.
"""

from newton_euler import Body, Frame, composite
from newton_euler.algebra.scalars import Scalar
from newton_euler.bodies.parametric import integrated
from newton_euler.bodies.solids import disk, half_disk, plate, rod


def thin_rod(m: Scalar, length: Scalar, exact: bool = False, frame: Frame | None = None) -> Body:
    """A thin uniform rod from the origin to x = ``length``, a Body, by integration of its mass over
    x (5.5, 7.3), from (5.13), (7.10); ``exact`` by SymPy's integrals. Any consistent units.
    :func:`newton_euler.bodies.solids.rod` makes a rod without integration.

    >>> body = thin_rod(3.0, 2.0)
    >>> round(body.centre.position(body.frame).x, 12)
    1.0
    >>> [round(x, 12) for x in body.about(body.frame).moments]
    [0.0, 4.0, 4.0]
    """
    frame = frame or Frame("rod")
    return integrated(
        lambda x: (x, 0, 0), (0, length), frame=frame, mass=m, exact=exact, name="thin rod"
    )


def three_rods(m: Scalar, length: Scalar, frame: Frame | None = None) -> Body:
    """A body of three equal thin rods at right angles (5.5, 7.3, 7.5, 7.9, 7.10), a Body. Each rod
    has the mass ``m``: rod 1 along z at x = -length/2, rod 2 along x through the origin, rod 3
    along y at x = length/2. Any consistent units. The mass is 3 m; the book transfers to G with m
    (7.10). ``about(frame)`` is the matrix of 7.3, ``about(frame).principal()`` has the axes of 7.5.

    >>> body = three_rods(12.0, 1.0)
    >>> body.about(body.frame).matrix
    ((8.0, -3.0, 3.0), (-3.0, 11.0, 0), (3.0, 0, 11.0))
    """
    frame = frame or Frame("rods")
    half = length / 2
    rods = [
        rod(length, frame.point("middle of rod 1", -half, 0, half), "z", mass=m, name="rod 1"),
        rod(length, frame, "x", mass=m, name="rod 2"),
        rod(length, frame.point("middle of rod 3", half, half, 0), "y", mass=m, name="rod 3"),
    ]
    return composite("three rods", rods)


def machine_part(
    r: Scalar,
    h: Scalar,
    s: Scalar,
    thickness: Scalar = 1,
    density: Scalar = 1,
    frame: Frame | None = None,
) -> Body:
    """A machine part of sheet metal: half disk and rectangle less a round hole (5.6, 7.10), a Body.
    The sheet lies in the plane x = 0, with the origin in the middle of the half disk's straight
    edge and y along that edge. Any consistent units.

    r : radius of the half disk, at z < 0
    h : height of the rectangle 2 r by h, at z > 0
    s : radius of the hole, in the middle of the rectangle

    >>> part = machine_part(1.0, 2.0, 0.5)
    >>> round(part.centre.position(part.frame).z, 6), part.about(part.frame).products
    (0.53244, (0, 0, 0))
    """
    frame = frame or Frame("sheet")
    middle = frame.point("middle of the rectangle", 0, 0, h / 2)
    sheet = density * thickness
    parts = [
        half_disk(r, frame, "x", "-z", density=sheet, name="half disk"),
        plate(2 * r, h, middle, "x", density=sheet, name="rectangle"),
    ]
    hole = disk(s, middle, "x", density=sheet, name="hole")
    return composite("machine part", parts, removed=[hole])
