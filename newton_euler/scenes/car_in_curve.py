"""A car in a curve, with tangential and normal acceleration (2.5)."""

from ..scalars import SingularError, is_numeric, size, sqrt, where


def speed_in_curve(rho, speed_rate, acceleration):
    """The speed in a curve of radius ``rho`` at which the magnitude of the total acceleration is ``acceleration``; from (2.14).

    speed_rate : rate of change of the speed; any consistent units. Raises :class:`~newton_euler.scalars.SingularError` if it alone is more than the
    total, which no speed can give.

    >>> round(speed_in_curve(rho=250.0, speed_rate=2.0, acceleration=3.0), 2)
    23.64
    """
    square = (acceleration - speed_rate) * (acceleration + speed_rate)
    if is_numeric(square) and size(where(square < 0, 1, 0)) > 0:
        raise SingularError(f"the total acceleration {acceleration!r} is less than its tangential component {speed_rate!r}: no speed gives that")
    return sqrt(sqrt(rho**2 * square))


def acceleration_in_curve(ground, rho, speed, speed_rate):
    """The acceleration of a car that heads along i of ``ground`` in a curve of radius ``rho`` to its left (2.14): along i and j.

    >>> from newton_euler import Frame
    >>> acceleration_in_curve(Frame("ground"), 200.0, 20.0, -4.0)
    Vector(-4.0, 2.0, 0 in ground)
    """
    return ground.vector(speed_rate, speed**2 / rho, 0)
