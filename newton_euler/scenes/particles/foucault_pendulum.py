"""Models of Foucault's pendulum: swings small or of any size, on an Earth at rest or rotating.

The origin is the support; z points up along the plumb line, x east and y north. The states are
those of the bob in plan, below its support. ``g`` is the effective gravity where the bob hangs at
rest, and the latitude that of the plumb line. On a cord of constant length the acceleration is G -
r (v.v + G.r)/length^2, where G is that of a free body (6.10).
"""

from dataclasses import replace

from ...algebra.portable import Values
from ...algebra.scalars import ZERO, Scalar, Triple, sqrt
from ...algebra.vectors import add3, cross3, dot3, scale3
from ...applications.earth import EARTH_RADIUS, EARTH_RATE, attraction3, earth_rate3
from ...motion.model import Model, Neglected
from ..catalogue import scene
from ..ladders import Ladder
from .low_pressure import STATES, air_near_low

PLACE = "place in plan, m"


def any_swing(length: Scalar, g: Scalar) -> Model:
    """The Model for an Earth at rest, with swings of any size: states x, y, dx, dy.

    >>> # -g sin(theta) cos(theta)
    >>> round(any_swing(5.0, 10.0).derivative((3.0, 0.0, 0.0, 0.0))[2], 9)
    -4.8
    """
    name = "Foucault's pendulum, any swing, Earth at rest"
    parameters = {"length": length, "g": g}
    return Model(name, parameters, STATES, _at_rest, neglects=(ROTATION,))


def full(
    length: Scalar, g: Scalar, latitude: Scalar, rate: Scalar = EARTH_RATE,
    radius: Scalar = EARTH_RADIUS,
) -> Model:  # fmt: skip
    """The Model for any swing with all terms of (6.10), at the bob: states x, y, dx, dy."""
    return Model("Foucault's pendulum", locals(), STATES, _full)


@scene(
    "6.11", "Foucault's pendulum", "small swings and any, on an Earth at rest and turning",
    ladder=True,
)  # fmt: skip
def ladder(
    length: Scalar = 67.0, g: Scalar = 9.81, latitude: Scalar = 0.8526, rate: Scalar = EARTH_RATE,
    radius: Scalar = EARTH_RADIUS, start: tuple[Scalar, ...] = (1.5, 0.0, 0.0, 0.0),
    t: Scalar = 100.0,
) -> Ladder:  # fmt: skip
    """The four models, for the position in plan (m) from x, y, dx, dy; by default of the Panthéon.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (0.01, 1e-4)]
    ["Foucault's pendulum, small swings, Earth at rest", "Foucault's pendulum"]
    """
    name = "Foucault's pendulum, small swings"
    still = air_near_low(0, g / length, rate=0)
    turned = air_near_low(latitude, g / length, rate=rate)
    still = replace(still, name=f"{name}, Earth at rest", neglects=(SIZE, ROTATION))
    turned = replace(turned, name=name, neglects=(SIZE,))
    models = still, turned, any_swing(length, g), full(length, g, latitude, rate, radius)
    return Ladder.of_models("Foucault's pendulum", PLACE, t, start, ("x", "y"), *models)


def below(s: Values, length: Scalar) -> tuple[Triple, Triple]:
    """Position and velocity of the bob, two triples, from those in plan, below the support."""
    z = -sqrt(length**2 - s.x * s.x - s.y * s.y)
    return (s.x, s.y, z), (s.dx, s.dy, -(s.x * s.dx + s.y * s.dy) / z)


def held(r: Triple, v: Triple, G: Triple, length: Scalar) -> Triple:
    """The acceleration in plan of a bob on a cord of this length; without the cord it is G."""
    return add3(G, scale3(-(dot3(v, v) + dot3(G, r)) / length**2, r))[:2]


def _at_rest(s, p, t):
    r, v = below(s, p.length)
    return s.dx, s.dy, *held(r, v, (ZERO, ZERO, -p.g), p.length)


def _full(s, p, t):
    r, v = below(s, p.length)
    omega = earth_rate3(p.latitude, p.rate)
    from_rest = s.x, s.y, r[2] + p.length
    seen = add3(cross3(cross3(omega, from_rest), omega), scale3(-2, cross3(omega, v)))
    return s.dx, s.dy, *held(r, v, add3(attraction3(from_rest, p.g, p.radius), seen), p.length)


SIZE = Neglected("the size of the swings", None, PLACE)
ROTATION = Neglected("the rotation of the Earth", None, PLACE)
