"""Horizontal motion of air near a centre of low pressure (6.11), counterclockwise in the north.

x east, y north, at one latitude. The pressure grows with the square of the distance from the
centre; ``pressure_gradient`` is its gradient over density and distance, 1/s^2. With g/length for it
the equations are those of small swings of Foucault's pendulum.
"""

from ...algebra.scalars import Scalar, radians, sqrt
from ...applications.earth import EARTH_RATE, coriolis_parameter
from ...motion.model import Model, Neglected, is_absent
from ..catalogue import scene
from ..closed_forms.harmonic import oscillation, plane_oscillation, rotated
from ..ladders import Ladder

POSITION = "position, m"
STATES = ("x", "y", "dx", "dy")
DAY = 86_400.0  # s


@scene(
    "6.11", "low", "air that starts at rest 300 km from the centre of a low, two days",
    2 * DAY, (3e5, 0.0, 0.0, 0.0),
    latitude=radians(45.0), pressure_gradient=1e-8,
)  # fmt: skip
@scene(
    "6.11", "low, friction", "air near a low with friction, which moves inwards",
    2 * DAY, (3e5, 0.0, 0.0, 0.0),
    latitude=radians(45.0), pressure_gradient=1e-8, friction=1e-5,
)  # fmt: skip
@scene(
    "6.11", "pendulum of Foucault", "67 m long, in Paris, ten minutes, by the equations of the low",
    600.0, (3.0, 0.0, 0.0, 0.0),
    latitude=radians(48.85), pressure_gradient=9.81 / 67.0,
)  # fmt: skip
def air_near_low(
    latitude: Scalar, pressure_gradient: Scalar = 0, friction: Scalar = 0,
    rate: Scalar = EARTH_RATE,
) -> Model:  # fmt: skip
    """The Model of a parcel of air (6.33): states x, y from the centre, and dx, dy, seen from the
    ground. Without friction, energy and absolute angular momentum are invariants; exact.

    pressure_gradient : inward acceleration over distance; 0 for air that moves in circles
    friction : deceleration over speed, 1/s

    >>> air = air_near_low(1.5707963267948966, pressure_gradient=1e-8, rate=5e-5)
    >>> # it moves north, to the centre, and is deflected to the east
    >>> air.derivative((0.0, -1e5, 0.0, 1.0))
    (0.0, 1.0, 0.0001, 0.001)
    """
    parameters, known = locals(), (_INVARIANTS, _exact) if is_absent(friction) else ()
    return Model("air near a low", parameters, STATES, _rates, *known)


@scene("6.11", "air near a low", "Earth at rest, Earth turning, friction", ladder=True)
def ladder(
    latitude: Scalar = 0.8, pressure_gradient: Scalar = 2e-9, friction: Scalar = 1e-5,
    rate: Scalar = EARTH_RATE, start: tuple[Scalar, ...] = (0.0, -4e5, 8.0, 0.0),
    t: Scalar = 10_800.0,
) -> Ladder:  # fmt: skip
    """The models of one parcel of air: the Earth at rest, rotating, and friction as well.

    pressure_gradient, friction : above 0, not negative; start : x, y, dx, dy in m and m/s

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (1e5, 2e4, 1e3)]
    ['air near a low, Earth at rest', 'air near a low, without friction', 'air near a low']
    """
    full = air_near_low(latitude, pressure_gradient, friction, rate)
    name, given = "air near a low", full.parameters
    of_still = _still, _ENERGY, _still_exact, (ROTATION, FRICTION)
    still = Model(f"{name}, Earth at rest", given, STATES, *of_still)
    of_smooth = _smooth, _INVARIANTS, _exact, (FRICTION,)
    smooth = Model(f"{name}, without friction", given, STATES, *of_smooth)
    return Ladder.of_models(name, POSITION, t, start, ("x", "y"), still, smooth, full)


def _still(s, p, t):
    return s.dx, s.dy, -p.pressure_gradient * s.x, -p.pressure_gradient * s.y


def _smooth(s, p, t):
    f = coriolis_parameter(p.latitude, p.rate)
    return s.dx, s.dy, -p.pressure_gradient * s.x + f * s.dy, -p.pressure_gradient * s.y - f * s.dx


def _rates(s, p, t):
    dx, dy, ddx, ddy = _smooth(s, p, t)
    return dx, dy, ddx - p.friction * s.dx, ddy - p.friction * s.dy


def _energy(s, p, t):
    return (s.dx * s.dx + s.dy * s.dy + p.pressure_gradient * (s.x * s.x + s.y * s.y)) / 2


def _momentum(s, p, t):
    half = coriolis_parameter(p.latitude, p.rate) / 2
    return s.x * s.dy - s.y * s.dx + half * (s.x * s.x + s.y * s.y)


_ENERGY = {"energy over mass": _energy}
_INVARIANTS = {**_ENERGY, "absolute angular momentum over mass": _momentum}


def _exact(s, p, t):
    """In axes that rotate at the rate -f/2 the path is an ellipse about the centre."""
    half = coriolis_parameter(p.latitude, p.rate) / 2
    square = half * half + p.pressure_gradient
    x, dx = oscillation(s.x, s.dx - half * s.y, square, t)
    y, dy = oscillation(s.y, s.dy + half * s.x, square, t)
    return *rotated(x, y, -half * t), *rotated(dx + half * y, dy - half * x, -half * t)


def _still_exact(s, p, t):
    return plane_oscillation(s, p.pressure_gradient, t)


# -- bounds of what is neglected
#
# Coriolis and friction are accelerations along or across the velocity, which the energy bounds. A
# unit of acceleration at one instant changes the position later by sin(n u)/n with n^2 >=
# pressure_gradient >= 0: never by more than the time u passed since.


def _moved(s, p, t):
    """The most that an acceleration of 1/s times the speed can change the position until t."""
    return sqrt(2 * _energy(s, p, t)) * (t * t) / 2


def _by_rotation(s, p, t):
    f = coriolis_parameter(p.latitude, p.rate)
    return sqrt(f * f) * _moved(s, p, t)


ROTATION = Neglected("the rotation of the Earth", _by_rotation, POSITION)
FRICTION = Neglected("the friction", lambda s, p, t: p.friction * _moved(s, p, t), POSITION)
