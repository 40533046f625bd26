"""The space curve x = e^q, y = sin q, z = q^2 passed with constant speed (3.1)."""

from ..paths import along, at_speed
from ..scalars import exp, sin


def path(q):
    """(x, y, z) at the parameter q.

    >>> path(0.0)
    (1.0, 0.0, 0.0)
    """
    return exp(q), sin(q), q * q


def passing(ground, q, speed, speed_rate=0):
    """The point that passes q on the curve with this speed, towards growing q, as a moving Point of ``ground``.

    >>> from newton_euler import Frame
    >>> ground = Frame("ground")
    >>> print(passing(ground, 0.0, 2.0).velocity(ground))
    [1.41421, 1.41421, 0] in ground
    """
    return ground.point("P", *along(path, at_speed(path, q, speed, speed_rate)))
