"""Models of a projectile over the rotating Earth (6.9, 6.10), from a flat Earth at rest to the full
equations of motion in air.

All have the states x, y, z along ground axes (east, north, up) from a point of the surface, and vx,
vy, vz. The bounds of what a model neglects are errors of the position, and hold above the ground.
Air of uniform density decelerates by ``drag`` = density (drag coefficient) area/(2 mass), 1/m,
times the square of the speed: 2e-4 for a cannonball near the ground, 1e-8 at a height of 70 km.

>>> from newton_euler import smallest
>>> [smallest(ladder(), metres).model.name for metres in (5.0, 1.0, 0.1)]
['projectile, flat', 'projectile, Coriolis and effective gravity', 'projectile, full']
"""

from operator import attrgetter

from ...algebra.scalars import ZERO, Scalar, cos, sqrt
from ...algebra.vectors import ZERO3, add3, cross3, dot3, scale3, sub3
from ...applications import earth
from ...applications.earth import EARTH_RADIUS, EARTH_RATE, attraction3, centrifugal3, position3
from ...motion.model import Model, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import growth, stumpff, uniform_acceleration
from ..ladders import Ladder

POSITION = "position, m"
STATES = ("x", "y", "z", "vx", "vy", "vz")
START = 0.0, 0.0, 0.0, 200.0, 50.0, 200.0  # start of the scenes
# (2 omega t)^2 up to which the series is summed to round-off: five hours on the Earth
LARGEST = 8


@scene(
    "6.10", "projectile, rotation only",
    "the shot with constant g and the Coriolis acceleration only",
    40.0, START, rung="Coriolis to first order", g=9.82, latitude=0.8,
)  # fmt: skip
@scene(
    "6.10", "projectile", "a shot of 283 m/s over the rotating Earth, all terms",
    40.0, START, rung="full", g=9.82, latitude=0.8,
)  # fmt: skip
def shot(
    rung: str, g: Scalar, latitude: Scalar = 0, rate: Scalar = EARTH_RATE,
    radius: Scalar = EARTH_RADIUS, drag: Scalar = 0,
) -> Model:  # fmt: skip
    """The Model of this name, one of :data:`RUNGS`; some parameters only serve bounds.

    >>> shot("flat", 9.8).derivative((0.0, 0.0, 0.0, 1.0, 2.0, 3.0))
    (1.0, 2.0, 3.0, 0, 0, -9.8)
    """
    given = {"g": g, "latitude": latitude, "rate": rate, "radius": radius, "drag": drag}
    rhs, neglects, exact, invariants = RUNGS[rung]
    return Model(f"projectile, {rung}", given, STATES, rhs, invariants, exact, neglects)


@scene(
    "6.10", "projectile", "flat Earth, Coriolis, effective gravity, attraction of a sphere, air",
    ladder=True,
)  # fmt: skip
def ladder(
    g: Scalar = 9.82, latitude: Scalar = 0.8, rate: Scalar = EARTH_RATE,
    radius: Scalar = EARTH_RADIUS, drag: Scalar = 1e-8,
    start: tuple[Scalar, ...] = (0.0, 0.0, 0.0, 200.0, 0.0, 200.0), t: Scalar = 10.0,
) -> Ladder:  # fmt: skip
    """The :class:`~newton_euler.scenes.ladders.Ladder`: six models, or four if ``drag`` is 0."""
    rungs = (rung for rung in RUNGS if drag or "air" not in rung)
    models = (shot(rung, g, latitude, rate, radius, drag) for rung in rungs)
    return Ladder.of_models("projectile", POSITION, t, start, STATES[:3], *models)


_r, _v = attrgetter(*STATES[:3]), attrgetter(*STATES[3:])


def _down(p):
    return ZERO, ZERO, -p.g


def _omega(p):
    return earth.earth_rate3(p.latitude, p.rate)


def _air_drag(s, p):
    return scale3(-p.drag * sqrt(dot3(_v(s), _v(s))), _v(s))


def _flat(s, p, t):
    return *_v(s), *_down(p)


def _parabola(s, p, t):
    z, vz = uniform_acceleration(s.z, s.vz, -p.g, t)
    return s.x + s.vx * t, s.y + s.vy * t, z, s.vx, s.vy, vz


def _flat_in_air(s, p, t):
    return *_v(s), *add3(_down(p), _air_drag(s, p))


def _turned(s, p, t):
    """The flat shot with the Coriolis acceleration integrated once, 2 omega x (v t - g t^2/2)."""
    way = sub3(scale3(t, _v(s)), scale3(t * t / 2, _down(p)))
    return *sub3(_v(s), scale3(2, cross3(_omega(p), way))), *_down(p)


def _turned_exact(s, p, t):
    return *add3(_r(s), position3(t, _v(s), _down(p), _omega(p))), s.vx, s.vy, s.vz - p.g * t


def _uniform(s, p, t):
    return *_v(s), *add3(_plumb_line(p), scale3(-2, cross3(_omega(p), _v(s))))


def _plumb_line(p):
    """The effective gravity at the origin."""
    return add3(_down(p), centrifugal3(ZERO3, _omega(p), p.radius))


def _uniform_exact(s, p, t):
    """All of the series of :func:`.position3`: three times across 2 omega is -(2 omega)^2 once."""
    v, g, w = _v(s), _plumb_line(p), _omega(p)
    z = 4 * dot3(w, w) * t * t
    c3, c4 = stumpff(3, z, LARGEST) / 6, stumpff(4, z, LARGEST) / 24
    f1, f2 = t * (1 - z * c3), t * t / 2 * (1 - 2 * z * c4)
    f3, f4 = t * t * t * c3, t * t * t * t * c4
    moved = earth.coriolis_series(v, g, w, [(t, t * t / 2), (f2, f3), (f3, f4)])
    return *add3(_r(s), moved), *earth.coriolis_series(v, g, w, [(1, t), (f1, f2), (f2, f3)])


def _full(s, p, t):
    omega = _omega(p)
    seen = scale3(-2, cross3(omega, _v(s)))
    still = add3(attraction3(_r(s), p.g, p.radius), centrifugal3(_r(s), omega, p.radius))
    return *_v(s), *add3(still, seen)


def _full_in_air(s, p, t):
    rates = _full(s, p, t)
    return *rates[:3], *add3(rates[3:], _air_drag(s, p))


def _inertial(s, p):
    """Position from the Earth's centre, and velocity in the inertial frame, along ground axes."""
    rho = (s.x, s.y, s.z + p.radius)
    return rho, add3(_v(s), cross3(_omega(p), rho))


def _energy(s, p, t):
    rho, v = _inertial(s, p)
    return dot3(v, v) / 2 - p.g * p.radius**2 / sqrt(dot3(rho, rho))


def _momentum(s, p, t):
    return dot3(earth.earth_rate3(p.latitude, 1), cross3(*_inertial(s, p)))


_INVARIANTS = {"energy over mass": _energy, "angular momentum over mass, about the axis": _momentum}

# -- bounds of what is neglected
#
# Above the ground the attraction is at most g, the centrifugal acceleration at most rate^2 (R + d)
# at the distance d from the origin, and the Coriolis acceleration does no work. So d <= D(t) with
# D'' = g + rate^2 (R + D), and the error e of a model that keeps the Coriolis term grows as |e'| <=
# integral of what it leaves out; that the air decelerates both makes e' smaller. A Coriolis term
# that is left out makes the error 2 omega x (integral of the displacement), and to first order the
# displacement itself is wrong by as much. Nothing makes the speed larger than D'.


def _bounds(s, p):
    """At the start the distance from the origin, the speed, and the bound of the acceleration."""
    start = sqrt(dot3(_r(s), _r(s)))
    return start, sqrt(dot3(_v(s), _v(s))), p.g + p.rate**2 * (p.radius + start)


def _reach(s, p, t):
    """The distance d from the origin at the start, and the bound of what is added to it until t."""
    start, speed, most = _bounds(s, p)
    _, of_speed, of_acceleration = growth(p.rate, t)
    return start, speed * of_speed + most * of_acceleration


def _added(acceleration):
    """The bound of the error by at most ``acceleration(p, d)`` at the distance d."""

    def bound(s, p, t):
        start, added = _reach(s, p, t)
        return acceleration(p, start + added) * t * t / 2

    return bound


def _by_air(s, p, t):
    _, speed, most = _bounds(s, p)
    grown, added, _ = growth(p.rate, t)
    return p.drag * (speed * grown + most * added) ** 2 * t * t / 2


CORIOLIS = Neglected(
    "the Coriolis acceleration", lambda s, p, t: p.rate * t * _reach(s, p, t)[1], POSITION
)
SECOND_ORDER = Neglected(
    "the Coriolis acceleration beyond the first order in the rotation",
    lambda s, p, t: 2 * p.rate**2 * t * t / 3 * _reach(s, p, t)[1],
    POSITION,
)
CENTRIFUGAL = Neglected(
    "the centrifugal acceleration",
    _added(lambda p, d: p.rate**2 * (p.radius * cos(p.latitude) + d)),
    POSITION,
)
CENTRIFUGAL_CHANGE = Neglected(
    "the change of the centrifugal acceleration with place",
    _added(lambda p, d: p.rate**2 * d),
    POSITION,
)
CURVATURE = Neglected(
    "the change of the attraction with place", _added(lambda p, d: 3 * p.g * d / p.radius), POSITION
)
AIR = Neglected("the air", _by_air, POSITION)

# by name: right-hand side, what it neglects, exact solution, invariants in the inertial frame
RUNGS = {
    "flat": (_flat, (CORIOLIS, CENTRIFUGAL, CURVATURE, AIR), _parabola, {}),
    # (6.24): vx, vy, vz are without the rotation
    "Coriolis to first order": (
        _turned, (SECOND_ORDER, CENTRIFUGAL, CURVATURE, AIR), _turned_exact, {}
    ),
    # constant effective gravity (6.16)
    "Coriolis and effective gravity": (
        _uniform, (CENTRIFUGAL_CHANGE, CURVATURE, AIR), _uniform_exact, {}
    ),
    "flat in air": (_flat_in_air, (CORIOLIS, CENTRIFUGAL, CURVATURE), None, {}),
    # all terms of (6.10), and the attraction of a sphere (5.22)
    "full": (_full, (AIR,), None, _INVARIANTS),
    "full in air": (_full_in_air, (), None, {}),  # which rotates with the Earth
}  # fmt: skip
