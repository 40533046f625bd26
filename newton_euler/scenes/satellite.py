"""A satellite over the equator, as a ladder: the circle, Kepler's ellipse, and the ellipse that the Earth's bulge turns (5.5).

In the plane of the equator the attraction of an oblate Earth is mu/r^2 + 3 mu J2 R^2/(2 r^4), still towards the centre, so that the angular momentum
stays. ``oblateness`` is J2 R^2, in m^2.
"""

import math

from ..earth import EARTH_GM
from ..ladders import Ladder, Rung
from ..models import Model, Neglected
from ..scalars import cos, sin, sqrt
from .orbit import orbit

POSITION = "position, m"
EARTH_J2 = 1.082627e-3  # of the Earth's field, without unit (WGS 84)
EARTH_EQUATOR = 6.378137e6  # m, its radius there (WGS 84)
EARTH_OBLATENESS = EARTH_J2 * EARTH_EQUATOR**2


def circle(mu, r, sense=1):
    """A circle of the radius r, exactly: the one state is the azimuth ``angle`` (rad); sense is 1 for counterclockwise, -1 for clockwise.

    >>> circle(8.0, 2.0).derivative((0.0,))
    (1.0,)
    """
    neglects = (Neglected("the eccentricity", None, POSITION), BULGE)
    return Model("satellite, circle", {"mu": mu, "r": r, "sense": sense}, ("angle",), _circle, exact=_circle_exact, neglects=neglects)


def over_equator(mu, oblateness, swept):
    """The satellite over the equator of an oblate Earth: states r, r_rate and the azimuth ``angle``; ``swept`` is r^2 times the rate of the angle.

    >>> over_equator(8.0, 0.0, 4.0).derivative((2.0, 0.0, 0.0))  # on the circle
    (0.0, 0.0, 1.0)
    """
    parameters = {"mu": mu, "oblateness": oblateness, "swept": swept}
    return Model("satellite, over an oblate Earth", parameters, ("r", "r_rate", "angle"), _rates, {"energy over mass": _energy})


def ladder(mu=EARTH_GM, oblateness=EARTH_OBLATENESS, start=(7e6, 0.0, 0.0, 7.6e3), t=30_000.0):
    """Circle, ellipse, oblate Earth: a :class:`~newton_euler.ladders.Ladder` for the position in the plane, from the ``start`` x, y, v_x, v_y.

    >>> from newton_euler.ladders import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (5e6, 1e6, 1e3)]
    ['satellite, circle', 'satellite, ellipse', 'satellite, over an oblate Earth']
    """
    x, y, v_x, v_y = start
    r, angle, swept = math.hypot(x, y), math.atan2(y, x), x * v_y - y * v_x
    kepler = orbit(mu)
    rungs = (
        Rung(circle(mu, r, math.copysign(1.0, swept)), (angle,), _on_circle),
        Rung(Model("satellite, ellipse", kepler.parameters, kepler.states, kepler.rhs, kepler.invariants, kepler.exact, (BULGE,)), start, _place),
        Rung(over_equator(mu, oblateness, swept), (r, (x * v_x + y * v_y) / r, angle), _at_angle),
    )
    return Ladder("satellite", POSITION, t, rungs)


def _circle(s, p, t):
    return (_rate(p),)


def _circle_exact(s, p, t):
    return (s.angle + _rate(p) * t,)


def _rate(p):
    return p.sense * sqrt(p.mu / p.r) / p.r


def _rates(s, p, t):
    pull = p.mu / s.r**2 * (1 + 3 * p.oblateness / (2 * s.r**2))
    return s.r_rate, p.swept**2 / s.r**3 - pull, p.swept / s.r**2


def _energy(s, p, t):
    return (s.r_rate**2 + (p.swept / s.r) ** 2) / 2 - p.mu / s.r * (1 + p.oblateness / (2 * s.r**2))


def _on_circle(s, p, t):
    return p.r * cos(s.angle), p.r * sin(s.angle)


def _place(s, p, t):
    return s.x, s.y


def _at_angle(s, p, t):
    return s.r * cos(s.angle), s.r * sin(s.angle)


BULGE = Neglected("the bulge of the Earth", None, POSITION)
