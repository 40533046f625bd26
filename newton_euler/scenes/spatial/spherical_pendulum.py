"""The thin spherical pendulum: a uniform bar that hangs from a ball joint (10.4), a top with I0 = m
L^2/3 and I = 0. Its axis points from the joint along the bar, so that it hangs at theta = pi.

In plan, the tip is at x, y from the joint and below it: small swings or any, as of a simple
pendulum of the length 2 L/3. ``friction`` is the moment against the turning over moment of inertia
and rate, 1/s.
"""

from dataclasses import replace

from ...algebra.scalars import ZERO, Scalar, cos, sin
from ...algebra.vectors import add3, scale3
from ...motion.model import Model, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import plane_oscillation
from ..ladders import Ladder
from ..particles.foucault_pendulum import any_swing as on_cord
from ..particles.foucault_pendulum import below, held
from ..particles.low_pressure import STATES
from .top import momentum_difference, nonspinning_frame, nutation

PLACE = "place of the tip in plan, m"


@scene(
    "10.4", "spherical pendulum", "a bar on a ball joint, pushed sideways",
    8.0, (cos(1.2), sin(1.2), 0.0, 0.0, 0.1, 0.7),
    mass=3.0, length=2.0, g=9.81,
)  # fmt: skip
def pendulum(mass: Scalar, length: Scalar, g: Scalar) -> Model:
    """The Model without a singular position, a :func:`.top.nonspinning_frame`.

    >>> pendulum(3.0, 2.0, 9.81).parameters["I0"]
    4.0
    """
    return nonspinning_frame(mass * (length * length) / 3, 0, mass * g * length / 2, 0)


@scene(
    "10.4", "spherical pendulum, nodding", "its angle from the vertical alone",
    8.0, (2.0, 0.0),
    mass=3.0, length=2.0, g=9.81, theta=2.0, precession=1.5,
)  # fmt: skip
def nodding(mass: Scalar, length: Scalar, g: Scalar, theta: Scalar, precession: Scalar) -> Model:
    """The Model of ``theta`` (rad) alone, from a start with this rate psi': :func:`.top.nutation`.

    >>> # falls towards theta = pi
    >>> round(nodding(3.0, 2.0, 9.81, 3.0, 0.0).derivative((3.0, 0.0))[1], 6)
    1.03829
    """
    top = pendulum(mass, length, g).parameters
    difference = momentum_difference(top["I0"], 0, theta, precession, 0)
    return nutation(**top, momentum_difference=difference)


def small_swings(length: Scalar, g: Scalar) -> Model:
    """The Model of small swings without friction, on an ellipse: states x, y, dx, dy of the tip.

    >>> small_swings(3.0, 10.0).derivative((0.1, -0.2, 0.0, 0.2))
    (0.0, 0.2, -0.5, 1.0)
    """
    damped = small_swings_with_friction(length, g, 0)
    return replace(damped, name="bar, small swings", neglects=(SIZE, FRICTION))


def small_swings_with_friction(length: Scalar, g: Scalar, friction: Scalar) -> Model:
    """The Model of small swings with friction below the critical, 2 sqrt(3 g/(2 length))."""
    given, name = locals(), "bar, small swings with friction"
    return Model(name, given, STATES, _damped, {}, _damped_exact, (SIZE,))


def any_swing(length: Scalar, g: Scalar) -> Model:
    """The Model of any swing below the joint without friction: a bob on a cord, in 3 g/2."""
    return replace(on_cord(length, 1.5 * g), name="bar, any swing", neglects=(FRICTION,))


@scene(
    "10.4", "spherical pendulum", "small swings and any, with friction in the joint or without",
    ladder=True,
)  # fmt: skip
def ladder(
    length: Scalar = 1.0, g: Scalar = 9.81, friction: Scalar = 0.02,
    start: tuple[Scalar, ...] = (0.05, 0.0, 0.0, 0.1), t: Scalar = 5.0,
) -> Ladder:  # fmt: skip
    """The four models, for the position of the tip in plan (m) from the ``start`` x, y, dx, dy.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (0.01, 1e-5)]
    ['bar, small swings', 'bar, any swing with friction']
    """
    damped = small_swings_with_friction(length, g, friction)
    full = Model("bar, any swing with friction", damped.parameters, STATES, _full)
    models = small_swings(length, g), damped, any_swing(length, g), full
    return Ladder.of_models("spherical pendulum", PLACE, t, start, ("x", "y"), *models)


def _square(p):
    """The square of the angular frequency of small swings."""
    return 3 * p.g / (2 * p.length)


def _damped(s, p, t):
    return s.dx, s.dy, -_square(p) * s.x - p.friction * s.dx, -_square(p) * s.y - p.friction * s.dy


def _damped_exact(s, p, t):
    return plane_oscillation(s, _square(p), t, p.friction)


def _full(s, p, t):
    r, v = below(s, p.length)
    free = add3((ZERO, ZERO, -3 * p.g / 2), scale3(-p.friction, v))
    return s.dx, s.dy, *held(r, v, free, p.length)


SIZE = Neglected("the size of the swings", None, PLACE)
FRICTION = Neglected("the friction in the joint", None, PLACE)
