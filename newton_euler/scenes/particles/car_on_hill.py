"""A car on a hill, driven by a force at its wheels (11.19)."""

from collections.abc import Callable
from math import inf

from ...algebra.scalars import Scalar, atan, sin, sqrt
from ...motion.model import Model, ModelError, Named, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import constant_rate, integrated_square
from ..ladders import Ladder

WAY = "distance up the hill, m"
STATES = ("s", "v")


@scene(
    "11.19", "car on a hill", "a car of constant power over wavy ground", 60.0, (0.0, 10.0),
    m=1200.0, wheel_mass=20.0, gyration=0.25, radius=0.3, air=0.5, g=9.81,
    force=lambda s, p, t: 40e3 / s.v, slope=lambda s, p, t: 0.08 * sin(s.s / 64),
)  # fmt: skip
def car(
    m: Scalar, wheel_mass: Scalar, gyration: Scalar, radius: Scalar, air: Scalar, g: Scalar,
    force: Scalar | Callable, slope: Scalar | Callable, wheels: Scalar = 4,
) -> Model:  # fmt: skip
    """The Model of a car whose wheels roll without slipping, against the air: states s, the
    distance up the hill, and v.

    m, wheel_mass : mass of the whole car, wheels included, and of each wheel
    gyration, radius : of each wheel; gyration is its radius of gyration about the axle
    air : the drag over the square of the speed, rho C_D A/2, kg/m
    force, slope : at the wheels, and of the road (rad, positive uphill); numbers, or laws (s, p, t)

    >>> car(1000.0, 50.0, 0.3, 0.3, 0.5, 10.0, force=1250.0, slope=0.0).derivative((0.0, 10.0))
    (10.0, 1.0)
    """
    return Model("car on wheels, in air", locals(), STATES, _air_rates)


@scene("11.19", "car on a hill", "a particle, a car on wheels, air", ladder=True)
def ladder(
    m: Scalar = 1200.0, wheel_mass: Scalar = 20.0, gyration: Scalar = 0.25, radius: Scalar = 0.3,
    air: Scalar = 0.4, g: Scalar = 9.81, force: Scalar = 2500.0, slope: Scalar = 0.08,
    start: tuple[Scalar, ...] = (0.0, 10.0), t: Scalar = 10.0,
) -> Ladder:  # fmt: skip
    """The models of one start, for the distance (m) until ``t``: particle, wheels, air.

    start : s, v; the rest are numbers, as for :func:`car`.
    Raises :class:`~newton_euler.motion.model.ModelError` for a car that comes to rest before ``t``.
    The fullest model has no closed form that holds for a force both larger and smaller than the
    component of the weight along the road.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (10.0, 5.0, 0.1)]
    ['car, particle', 'car on wheels', 'car on wheels, in air']
    """
    full = car(m, wheel_mass, gyration, radius, air, g, force, slope)
    if start[1] < 0 or _stops(Named("parameter", full.parameters), start[1]) < t:
        raise ModelError(
            f"the car goes uphill until t = {t!r} only with more than {force!r} N at {start[1]!r}"
        )
    name, given = "car, particle", full.parameters
    particle = constant_rate(name, given, lambda p: _left(p) / p.m, *STATES, neglects=(WHEELS, AIR))
    name = "car on wheels"
    wheels = constant_rate(name, given, lambda p: _left(p) / _mass(p), *STATES, neglects=(AIR,))
    return Ladder.of_models("car on a hill", WAY, t, start, ("s",), particle, wheels, full)


def _stops(p, v):
    """The time at which the car comes to rest; inf if it does not."""
    held, mass = -_left(p), _mass(p)
    if held <= 0:
        return inf
    return mass * atan(v * sqrt(p.air / held)) / sqrt(p.air * held) if p.air else mass * v / held


def _left(p):
    """The resultant force along the slope, without the air."""
    return p.force - p.m * p.g * sin(p.slope)


def _wheels(p):
    """The moments of inertia of the wheels over radius^2, which act as an added mass."""
    ratio = p.gyration / p.radius
    return p.wheels * p.wheel_mass * (ratio * ratio)


def _mass(p):
    return p.m + _wheels(p)


def _air_rates(s, p, t):
    return s.v, (_left(p) - p.air * s.v * s.v) / _mass(p)


# -- bounds of what is neglected: against the air the car is never faster than without it


def _by_wheels(s, p, t):
    left = _left(p)
    return sqrt(left * left) / p.m * _wheels(p) / _mass(p) * (t * t) / 2


def _by_air(s, p, t):
    left = _left(p)
    return p.air / _mass(p) * integrated_square(s.v, sqrt(left * left) / _mass(p), t)


WHEELS = Neglected("the moments of inertia of the wheels", _by_wheels, WAY)
AIR = Neglected("the resistance of the air", _by_air, WAY)
