"""Motion in a space station that rotates about its axis z at ``omega``, so that bodies at its rim
have weight (6.7); the book's station has omega < 0.

A body let go moves uniformly in the inertial frame; seen from the station its path is a spiral, or
a circle, but in general not the limacon that the book names.
"""

from dataclasses import replace

from ...algebra.scalars import ZERO, Scalar, sqrt
from ...algebra.vectors import add3, cross3, scale3
from ...motion.model import Model, ModelError, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import growth, rotated, uniform_acceleration
from ..ladders import Ladder

POSITION = "position, m"
STATES = ("x", "y", "dx", "dy")
CREEP = 0.01  # m/s, small against any throw, so that the drag has a derivative at rest


def station_rate(g: Scalar, radius: Scalar) -> Scalar:
    """The rate sqrt(g/radius), rad/s, at which a body at the rim has its weight on the Earth.

    >>> round(station_rate(9.81, 100.0)*60/6.2832, 2)  # turns a minute
    2.99
    """
    return sqrt(g / radius)


@scene(
    "6.7", "space station", "a body let go 20 m from the axis, until it is at the rim", 15.0,
    (20.0, 0.0, 0.0, 0.0), omega=-station_rate(9.81, 100.0),
)  # fmt: skip
def free_body(omega: Scalar) -> Model:
    """The Model of a free body seen in the station (6.10): states x, y along station axes from the
    axis of rotation, dx, dy seen there.

    >>> # centrifugal 0.5 along x, Coriolis 1.0 and -1.0
    >>> free_body(0.5).derivative((2.0, 0.0, 1.0, 1.0))
    (1.0, 1.0, 1.5, -1.0)
    """
    return Model("free body in a turning station", locals(), STATES, _rates, _INVARIANTS, _exact)


def body_in_air(omega: Scalar, air: Scalar, creep: Scalar = CREEP) -> Model:
    """The Model of :func:`free_body` in the air, which rotates with the station.

    air : rho C_D A/(2 m), 1/m: drag over mass and square of the speed seen there
    creep : a speed, m/s, well below which the drag is linear, so that a body may start at rest

    >>> # 0.25 against the velocity
    >>> body_in_air(0.5, 0.01, creep=0.0).derivative((2.0, 0.0, 3.0, 4.0))
    (3.0, 4.0, 4.35, -3.2)
    """
    return Model("body in the air of a turning station", locals(), STATES, _air_rates)


@scene("6.7", "space station", "uniform gravity, the turning station, air", ladder=True)
def ladder(
    omega: Scalar = -0.3, radius: Scalar = 100.0, air: Scalar = 0.002,
    start: tuple[Scalar, ...] = (98.5, 0.0, -2.0, 1.0), t: Scalar = 1.0,
) -> Ladder:  # fmt: skip
    """The models of a throw near (radius, 0) at the rim: uniform gravity, the turning station, air.

    omega : not zero; start : x, y, dx, dy in m and m/s. t : before it is at the floor.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (2.0, 0.1)]
    ['uniform gravity in a turning station', 'free body in a turning station']
    """
    if omega == 0:
        raise ModelError("a station that does not turn has no weight: omega must not be zero")
    full = body_in_air(omega, air)
    parameters = {**full.parameters, "radius": radius}
    name, neglects = "uniform gravity in a turning station", (CORIOLIS, CHANGE, AIR)
    uniform = Model(name, parameters, STATES, _uniform, {}, _parabola, neglects)
    free = replace(free_body(omega), parameters=parameters, neglects=(AIR,))
    return Ladder.of_models("space station", POSITION, t, start, ("x", "y"), uniform, free, full)


def _uniform(s, p, t):
    return s.dx, s.dy, p.omega * p.omega * p.radius, ZERO


def _parabola(s, p, t):
    x, dx = uniform_acceleration(s.x, s.dx, p.omega * p.omega * p.radius, t)
    return x, s.y + s.dy * t, dx, s.dy


def _rates(s, p, t):
    omega, r, v = (ZERO, ZERO, p.omega), (s.x, s.y, ZERO), (s.dx, s.dy, ZERO)
    centripetal, coriolis = cross3(omega, cross3(omega, r)), scale3(2, cross3(omega, v))
    return s.dx, s.dy, *scale3(-1, add3(centripetal, coriolis))[:2]


def _air_rates(s, p, t):
    dx, dy, ddx, ddy = _rates(s, p, t)
    hold = p.air * sqrt(s.dx * s.dx + s.dy * s.dy + p.creep * p.creep)
    return dx, dy, ddx - hold * s.dx, ddy - hold * s.dy


def _inertial_velocity(s, p):
    """The velocity in the inertial frame, along station axes."""
    return s.dx - p.omega * s.y, s.dy + p.omega * s.x


def _angular_momentum(s, p, t):
    wx, wy = _inertial_velocity(s, p)
    return s.x * wy - s.y * wx


_INVARIANTS = {
    "inertial speed, squared": lambda s, p, t: sum(v * v for v in _inertial_velocity(s, p)),
    "angular momentum over mass": _angular_momentum,
}


def _exact(s, p, t):
    """The straight line r0 + w t, turned back by omega t."""
    wx, wy = _inertial_velocity(s, p)
    x, y = rotated(s.x + wx * t, s.y + wy * t, -p.omega * t)
    dx, dy = rotated(wx, wy, -p.omega * t)
    return x, y, dx + p.omega * y, dy - p.omega * x


# -- bounds of what is neglected
#
# Seen in the station neither the Coriolis acceleration nor the air makes the body faster, so its
# speed v and the distance r from the axis obey v' <= omega^2 r, r' <= v: both grow no faster than
# those of a body on a spoke. In uniform gravity no force depends on position or velocity, so the
# double integral of what is left out is the error; that of the Coriolis acceleration, 2 omega x v,
# is the integral of 2 omega x (displacement). The same is true of the air, for a free body in the
# inertial frame.


def _bounds(s, p, t):
    """Speed and centrifugal acceleration at the start, and what bounds their growth until t."""
    v, a = sqrt(s.dx * s.dx + s.dy * s.dy), p.omega * p.omega * sqrt(s.x * s.x + s.y * s.y)
    return v, a, growth(p.omega, t)


def _by_coriolis(s, p, t):
    """By the integral of the displacement: sinh(x) - x <= x (cosh(x) - 1)/3, x = omega t."""
    v, a, (_, _, of_acceleration) = _bounds(s, p, t)
    return 2 * sqrt(p.omega * p.omega) * of_acceleration * (v + a * t / 3)


def _by_change(s, p, t):
    v, a, (_, of_speed, of_acceleration) = _bounds(s, p, t)
    away = sqrt((s.x - p.radius) * (s.x - p.radius) + s.y * s.y)
    return p.omega * p.omega * (away + v * of_speed + a * of_acceleration) * (t * t) / 2


def _by_air(s, p, t):
    v, a, (grown, added, _) = _bounds(s, p, t)
    fastest = v * grown + a * added
    return p.air * fastest * sqrt(fastest * fastest + p.creep * p.creep) * (t * t) / 2


CORIOLIS = Neglected("the Coriolis acceleration", _by_coriolis, POSITION)
CHANGE = Neglected("the change of the centripetal acceleration with place", _by_change, POSITION)
AIR = Neglected("the air", _by_air, POSITION)
