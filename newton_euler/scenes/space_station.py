"""A space station of radius r that turns about its axis, so that its rim feels like the ground (6.7).

Station axes turn with it: the axis of rotation is z, along which ``omega`` is positive; the book's station has omega < 0. A body let go moves on a
straight line at constant speed among the stars; from the station its path looks like a spiral, or a circle, but in general not like the
limacon that the book names.
"""

from ..models import second_order
from ..scalars import ZERO, cos, sin, sqrt
from ..vectors import add3, cross3, scale3


def station_rate(g, radius):
    """The rate of rotation, rad/s, at which the floor at the rim pushes like the ground of the Earth: sqrt(g/radius).

    >>> round(station_rate(9.81, 100.0)*60/6.2832, 2)  # turns a minute
    2.99
    """
    return sqrt(g / radius)


def rim_speed(g, radius):
    """The speed of the rim at this rate, sqrt(g radius): who runs as fast against the rotation stands still among the stars, and floats."""
    return sqrt(g * radius)


def free_body(omega):
    """The model of a body let go in the station (6.10): states x, y along station axes from the axis of rotation, dx, dy seen there.

    >>> free_body(0.5).derivative((2.0, 0.0, 1.0, 1.0))  # centrifugal 0.5 along x, Coriolis 1.0 and -1.0
    (1.0, 1.0, 1.5, -1.0)
    """
    return second_order(
        "free body in a turning station", {"omega": omega}, ("x", "y"), _accelerations, exact=_exact,
        invariants={
            "speed among the stars, squared": lambda s, p, t: sum(v * v for v in _among_stars(s, p)),
            "angular momentum over mass": lambda s, p, t: _moment((s.x, s.y), _among_stars(s, p)),
        },
    )  # fmt: skip


def _accelerations(s, p, t):
    omega, r, v = (ZERO, ZERO, p.omega), (s.x, s.y, ZERO), (s.dx, s.dy, ZERO)
    centripetal, coriolis = cross3(omega, cross3(omega, r)), scale3(2, cross3(omega, v))
    return scale3(-1, add3(centripetal, coriolis))[:2]


def _among_stars(s, p):
    """The velocity among the stars, along station axes."""
    return s.dx - p.omega * s.y, s.dy + p.omega * s.x


def _moment(r, v):
    return r[0] * v[1] - r[1] * v[0]


def _exact(s, p, t):
    """The straight line r0 + w t, turned back by omega t."""
    w = _among_stars(s, p)
    x, y = _turned_back((s.x + w[0] * t, s.y + w[1] * t), p.omega * t)
    dx, dy = _turned_back(w, p.omega * t)
    return x, y, dx + p.omega * y, dy - p.omega * x


def _turned_back(r, angle):
    c, s = cos(angle), sin(angle)
    return c * r[0] + s * r[1], c * r[1] - s * r[0]
