"""Kepler's problem: a body under the attraction of a fixed centre, in the plane of its orbit; exact
for ellipses. Satellites over the equator of an oblate Earth.

The exact solution is by the eccentric anomaly, written with 1 - e and 1 - cos(E): no digits cancel,
however close the ellipse is to a parabola. Over the equator the attraction is mu/r^2 + 3 mu J2
R^2/(2 r^4) towards the centre (5.5); ``oblateness`` is J2 R^2, in m^2.
"""

import math
from dataclasses import replace

from ...algebra import scalars
from ...algebra.scalars import Scalar, atan2, cos, epsilon, is_numeric, max_abs, sin, sqrt, where
from ...applications.earth import EARTH_GM
from ...motion.model import Model, ModelError, Neglected, comparable
from ..catalogue import scene
from ..closed_forms.double_double import doubled
from ..closed_forms.harmonic import constant_rate, stumpff
from ..ladders import Ladder, Rung, observed_states

POSITION = "position, m"
EARTH_J2 = 1.082627e-3  # J2 of the Earth's field, without unit (WGS 84)
EARTH_EQUATOR = 6.378137e6  # m, its radius there (WGS 84)
EARTH_OBLATENESS = EARTH_J2 * EARTH_EQUATOR**2


@scene(
    "5.10", "planet", "a planet on an ellipse of eccentricity 0.44",
    30.0, (0.6, 0.8, -0.96, 0.72), mu=1.0,
)  # fmt: skip
@scene(
    "5.10", "planet, eccentric", "a comet that passes close to its sun: eccentricity 0.75",
    20.0, (0.6, 0.8, -0.4, 0.3), mu=1.0,
)  # fmt: skip
def orbit(mu: Scalar) -> Model:
    """The Model of an orbit: states x, y, v_x, v_y; invariants ``energy`` and ``angular_momentum``
    over mass, and the Laplace vector (the eccentricity, towards the closest point).

    mu : the constant of the attraction mu/r^2, m^3/s^2
    The exact solution, for ellipses, takes the numbers given as exact. Its error in position is at
    most 7 times the round-off of the distance from the centre plus t times the speed there
    (measured on 2000 random ellipses, two thirds of them almost parabolas). It raises
    :class:`~newton_euler.motion.model.ModelError` for other orbits, and expressions.

    >>> import math
    >>> [round(x, 9) for x in orbit(1.0).solution(math.pi/2, (1.0, 0.0, 0.0, 1.0))]
    [0.0, 1.0, -1.0, 0.0]
    """
    states = "x", "y", "v_x", "v_y"
    return Model("Kepler's orbit", {"mu": mu}, states, _rates, _INVARIANTS, _exact)


def _rates(s, p, t):
    r = _distance(s)
    pull = -p.mu / (r * r * r)
    return s.v_x, s.v_y, pull * s.x, pull * s.y


def _distance(s):
    return sqrt(s.x * s.x + s.y * s.y)


def _angular_momentum(s):
    return s.x * s.v_y - s.y * s.v_x


_INVARIANTS = {
    "energy": lambda s, p, t: (s.v_x**2 + s.v_y**2) / 2 - p.mu / _distance(s),
    "angular_momentum": lambda s, p, t: _angular_momentum(s),
    "laplace_x": lambda s, p, t: s.v_y * _angular_momentum(s) / p.mu - s.x / _distance(s),
    "laplace_y": lambda s, p, t: -s.v_x * _angular_momentum(s) / p.mu - s.y / _distance(s),
}


def _exact(s, p, t):
    """The state at t by the eccentric anomaly; nan, when traced, if the orbit is not an ellipse."""
    x, y, v_x, v_y, mu, t = comparable("orbit", s.x, s.y, s.v_x, s.v_y, p.mu, t)
    _check(x, y, v_x, v_y, mu, t)
    r0, along, swept = sqrt(x * x + y * y), x * v_x + y * v_y, x * v_y - y * v_x
    beta = _beta(x, y, v_x, v_y, mu, r0)
    closed = beta * abs(swept) > 0
    if is_numeric(beta) and max_abs(where(closed, 0, 1)):
        raise ModelError("the orbit is not an ellipse (its energy is not below 0): integrate it")
    beta = where(closed, beta, 1)
    root = sqrt(beta)
    # e sin(E0), e cos(E0), sqrt(1 - e^2)
    rise, depth, across = along * root / mu, 1 - r0 * beta / mu, swept * root / mu
    e, E0 = sqrt(rise * rise + depth * depth), atan2(rise, depth)
    rest = across * across / (1 + e)  # 1 - e
    M = _mean_anomaly(E0, rest, sin(E0)) + beta * root / mu * t
    M = atan2(sin(M), cos(M))
    E = _anomaly_near(M, e, rest)
    for _ in range(2 if epsilon(E) > 1e-20 else 5):  # each cubes the error, a thousandth at first
        E = _halley(E, e, rest, M)
    sine, drop = sin(E), 2 * sin(E / 2) ** 2
    # the direction of the closest approach
    i, j = (cos(E0) * q / r0 - sin(E0) * v / root for q, v in ((x, v_x), (y, v_y)))
    X, Y, rate = mu / beta * (rest - drop), mu / beta * across * sine, root / (rest + e * drop)
    V_x, V_y = -rate * sine, rate * across * (1 - drop)
    return tuple(
        where(closed, out, math.nan)
        for out in (X * i - Y * j, X * j + Y * i, V_x * i - V_y * j, V_x * j + V_y * i)
    )


def _check(x, y, v_x, v_y, mu, t):
    state = x, y, v_x, v_y
    if not all(map(is_numeric, (*state, mu, t))):
        return  # it is being traced
    if not all(map(scalars.is_finite, (*state, mu, t))) or max_abs(where(mu <= 0, 1, 0)):
        raise ModelError(f"an orbit needs finite numbers, mu > 0; got mu = {mu}, {state}, t = {t}")
    one, two = x * v_y, y * v_x
    if max_abs(where(abs(one - two) <= 4 * epsilon(one - two) * (abs(one) + abs(two)), 1, 0)):
        raise ModelError("the orbit is a straight line through the centre: no angular momentum")


def _beta(x, y, v_x, v_y, mu, r):
    """mu/a = 2 mu/r - v^2; with twice the digits, and r's own rounding, where they cancel."""
    pull, square = 2 * mu / r, v_x * v_x + v_y * v_y
    short = doubled(lambda x, y, r: x * x + y * y - r * r, x, y, r) / (2 * r)
    rest = (doubled(lambda mu, pull, r: mu + mu - pull * r, mu, pull, r) - pull * short) / r
    precise = doubled(lambda pull, v_x, v_y: pull - v_x * v_x - v_y * v_y, pull, v_x, v_y) + rest
    return where(abs(pull - square) < square / 4, precise, pull - square)


def _anomaly_near(M, e, rest):
    """E to about a thousandth from M in [-pi, pi] (F. L. Markley, Celest. Mech. 63, 101, 1995)."""
    square = math.pi**2
    a = (3 * square + 1.6 * math.pi * (math.pi - abs(M)) / (1 + e)) / (square - 6)
    d = 3 * rest + a * e
    q, r = 2 * a * d * rest - M * M, abs(3 * a * d * (d - rest) * M + M * M * M)
    w = (r + sqrt(q * q * q + r * r)) ** (2 / 3)
    E = 2 * r * w / (w * w + w * q + q * q)
    return (where(M < 0, -E, E) + M) / d


def _mean_anomaly(E, rest, sine):
    """E - e sin(E) with e = 1 - rest, in which nothing cancels."""
    small = abs(E) < 1
    z = where(small, E * E, 0)
    return where(small, E * z / 6 * stumpff(3, z), E - sine) + rest * sine


def _halley(E, e, rest, M):
    """One step of third order towards the root of Kepler's equation."""
    sine, drop = sin(E), 2 * sin(E / 2) ** 2
    late, slope = _mean_anomaly(E, rest, sine) - M, rest + e * drop
    return E - 2 * late * slope / (2 * slope * slope - late * e * sine)


def circle(mu: Scalar, r: Scalar, sense: Scalar = 1) -> Model:
    """The Model of a circular orbit of radius r; its only state is the azimuth ``angle`` (rad).
    ``sense`` is 1 for counterclockwise, -1 for clockwise.

    >>> circle(8.0, 2.0).derivative((0.0,))
    (1.0,)
    """
    given, neglects = {"mu": mu, "r": r, "sense": sense}, (ECCENTRICITY, BULGE)
    name, rate = "satellite, circle", lambda p: p.sense * sqrt(p.mu / p.r) / p.r
    return constant_rate(name, given, rate, "angle", neglects=neglects)


@scene(
    "5.10", "satellite", "a satellite over the equator of an oblate Earth, five revolutions",
    30_000.0, (7e6, 0.0, 0.0),
    mu=EARTH_GM, oblateness=EARTH_OBLATENESS, swept=7e6 * 7.6e3,
)  # fmt: skip
def over_equator(mu: Scalar, oblateness: Scalar, swept: Scalar) -> Model:
    """The Model of a satellite over the equator of an oblate Earth: states r, r_rate and the
    azimuth ``angle``; ``swept`` is r^2 times the rate of the angle.

    >>> over_equator(8.0, 0.0, 4.0).derivative((2.0, 0.0, 0.0))  # on the circle
    (0.0, 0.0, 1.0)
    """
    name, states = "satellite, over an oblate Earth", ("r", "r_rate", "angle")
    parameters = {"mu": mu, "oblateness": oblateness, "swept": swept}
    return Model(name, parameters, states, _oblate, {"energy over mass": _oblate_energy})


@scene(
    "5.10", "satellite", "circle, Kepler's ellipse, ellipse that the Earth's bulge turns",
    ladder=True,
)  # fmt: skip
def ladder(
    mu: Scalar = EARTH_GM, oblateness: Scalar = EARTH_OBLATENESS,
    start: tuple[Scalar, ...] = (7e6, 0.0, 0.0, 7.6e3), t: Scalar = 30_000.0,
) -> Ladder:  # fmt: skip
    """The models circle, ellipse and oblate Earth, for the position from x, y, v_x, v_y.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (5e6, 1e6, 1e3)]
    ['satellite, circle', 'satellite, ellipse', 'satellite, over an oblate Earth']
    """
    x, y, v_x, v_y = start
    r, angle, swept = math.hypot(x, y), math.atan2(y, x), x * v_y - y * v_x
    ellipse = replace(orbit(mu), name="satellite, ellipse", neglects=(BULGE,))
    rungs = (
        Rung(circle(mu, r, math.copysign(1.0, swept)), (angle,), _on_circle),
        Rung(ellipse, start, observed_states("x", "y")),
        Rung(over_equator(mu, oblateness, swept), (r, (x * v_x + y * v_y) / r, angle), _at_angle),
    )
    return Ladder("satellite", POSITION, t, rungs)


def _oblate(s, p, t):
    pull = p.mu / s.r**2 * (1 + 3 * p.oblateness / (2 * s.r**2))
    return s.r_rate, p.swept**2 / s.r**3 - pull, p.swept / s.r**2


def _oblate_energy(s, p, t):
    return (s.r_rate**2 + (p.swept / s.r) ** 2) / 2 - p.mu / s.r * (1 + p.oblateness / (2 * s.r**2))


def _on_circle(s, p, t):
    return p.r * cos(s.angle), p.r * sin(s.angle)


def _at_angle(s, p, t):
    return s.r * cos(s.angle), s.r * sin(s.angle)


ECCENTRICITY = Neglected("the eccentricity", None, POSITION)
BULGE = Neglected("the bulge of the Earth", None, POSITION)
