"""A body of three equal thin rods at right angles (5.5, 7.3, 7.5, 7.9, 7.10)."""

from ..frames import Frame
from ..mass import composite
from ..solids import rod


def three_rods(m, length, frame=None):
    """The body of rods of mass ``m`` each: rod 1 along z at x = -L/2, rod 2 along x through the origin, rod 3 along y at x = L/2.

    Its mass is 3 m; the book transfers to G with m (7.10). ``about(frame)`` is the matrix of 7.3, ``about(frame).principal()`` the axes of 7.5.

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
