"""Foucault's pendulum on the rotating Earth, as a ladder: swings small or of any size, on an Earth
at rest or rotating.

The axes are z up the plumb line, from the point from which the bob hangs, x east and y north; x, y
are the place of the bob in plan. So ``g`` is the effective gravity where the bob hangs at rest, and
the latitude is that of the plumb line. A cord of constant length pulls as hard as it must, and the
acceleration of the bob is G - r (v.v + G.r)/length^2, where G is that of a free body (6.10). The
bob stays below the level of its support.
"""

from dataclasses import replace

from ...algebra.scalars import ZERO, sqrt
from ...algebra.vectors import add3, cross3, dot3, scale3
from ...applications.earth import EARTH_RADIUS, EARTH_RATE, attraction3, earth_rate3
from ...motion.model import Model, Neglected
from ..catalogue import scene
from ..ladders import Ladder
from .low_pressure import STATES, air_near_low

PLACE = "place in plan, m"


def any_swing(length, g):
    """The pendulum on an Earth at rest, with swings of any size below the level of its support:
    states x, y, dx, dy.

    >>> # -g sin(theta) cos(theta)
    >>> round(any_swing(5.0, 10.0).derivative((3.0, 0.0, 0.0, 0.0))[2], 9)
    -4.8
    """
    name = "Foucault's pendulum, any swing, Earth at rest"
    parameters = {"length": length, "g": g}
    return Model(name, parameters, STATES, _at_rest, neglects=(ROTATION,))


def full(length, g, latitude, rate=EARTH_RATE, radius=EARTH_RADIUS):
    """Swings of any size and all terms of (6.10): with what the place in the swing changes in the
    centrifugal acceleration and in gravity.
    """
    return Model("Foucault's pendulum", locals(), STATES, _full)


@scene(
    "6.11",
    "Foucault's pendulum",
    "small swings and any, on an Earth at rest and turning",
    ladder=True,
)
def ladder(
    length=67.0,
    g=9.81,
    latitude=0.8526,
    rate=EARTH_RATE,
    radius=EARTH_RADIUS,
    start=(1.5, 0.0, 0.0, 0.0),
    t=100.0,
):
    """Four models: a :class:`~newton_euler.scenes.ladders.Ladder` for the place in plan, m. Length
    and latitude are the Panthéon's; start is x, y, dx, dy.

    >>> from newton_euler.scenes.ladders import smallest
    >>> for metres in (0.01, 0.005, 1e-4):
    ...     print(smallest(ladder(), metres).model.name)
    Foucault's pendulum, small swings, Earth at rest
    Foucault's pendulum, small swings
    Foucault's pendulum
    """
    name = "Foucault's pendulum, small swings"
    still, turned = (
        air_near_low(0, g / length, rate=0),
        air_near_low(latitude, g / length, rate=rate),
    )
    still = replace(still, name=f"{name}, Earth at rest", neglects=(SIZE, ROTATION))
    turned = replace(turned, name=name, neglects=(SIZE,))
    models = still, turned, any_swing(length, g), full(length, g, latitude, rate, radius)
    return Ladder.of_models("Foucault's pendulum", PLACE, t, start, ("x", "y"), *models)


def below(s, length):
    """Position and velocity of the bob, two triples, from its place and velocity in plan."""
    z = -sqrt(length**2 - s.x * s.x - s.y * s.y)
    return (s.x, s.y, z), (s.dx, s.dy, -(s.x * s.dx + s.y * s.dy) / z)


def held(r, v, G, length):
    """The acceleration in plan of a body that would have the acceleration G if it were free, and is
    held at this distance from the origin.
    """
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
