"""Air near the centre of low pressure, on the level (6.11): why storms turn counterclockwise in the north.

Ground axes x east, y north, small against the Earth, so that the latitude is one number; the pressure grows with the square of the distance from the
centre, so that it pushes with ``push`` times the distance. The same equations describe the pendulum of Foucault, with push = g/length.
"""

from ..earth import EARTH_RATE, coriolis_parameter
from ..models import is_law, second_order
from ..scalars import cos, is_zero, scalar, sin, sqrt


def air_near_low(latitude, push=0, friction=0, rate=EARTH_RATE):
    """The model of a parcel of air: states x, y from the centre, dx, dy as seen from the ground (6.33).

    push : inward acceleration over distance, 1/s^2; 0 for free air, which runs in circles; friction : deceleration over speed, 1/s
    Without friction, energy and absolute angular momentum are invariants, and there is an exact solution.

    >>> air = air_near_low(1.5707963267948966, push=1e-8, rate=5e-5)
    >>> air.derivative((0.0, -1e5, 0.0, 1.0))  # it moves to the north, to the centre, and is turned aside to the east
    (0.0, 1.0, 0.0001, 0.001)
    """
    frictionless = not is_law(friction) and is_zero(scalar(friction))
    return second_order(
        "air near a low", {"latitude": latitude, "rate": rate, "push": push, "friction": friction}, ("x", "y"), _accelerations,
        invariants={"energy over mass": _energy, "absolute angular momentum over mass": _momentum} if frictionless else {},
        exact=_exact if frictionless else None,
    )  # fmt: skip


def _accelerations(s, p, t):
    f = coriolis_parameter(p.latitude, p.rate)
    return -p.push * s.x + f * s.dy - p.friction * s.dx, -p.push * s.y - f * s.dx - p.friction * s.dy


def _energy(s, p, t):
    return (s.dx * s.dx + s.dy * s.dy + p.push * (s.x * s.x + s.y * s.y)) / 2


def _momentum(s, p, t):
    return s.x * s.dy - s.y * s.dx + coriolis_parameter(p.latitude, p.rate) / 2 * (s.x * s.x + s.y * s.y)


def _exact(s, p, t):
    """An ellipse at the rate n about the centre, seen from axes that turn at f/2 to the left of the air."""
    half = coriolis_parameter(p.latitude, p.rate) / 2
    n = sqrt(half * half + p.push)
    c, S = cos(n * t), sin(n * t) / n
    wx, wy = s.dx - half * s.y, s.dy + half * s.x
    x, y = s.x * c + wx * S, s.y * c + wy * S
    dx, dy = wx * c - n * n * s.x * S, wy * c - n * n * s.y * S
    return *_turned(x, y, half * t), *_turned(dx + half * y, dy - half * x, half * t)


def _turned(x, y, angle):
    """Turned clockwise."""
    c, s = cos(angle), sin(angle)
    return c * x + s * y, c * y - s * x
