"""A thin bar that swings from a ball joint (10.4) as a ladder: small swings or any, with friction in the joint or without.

A bar of the length L swings like a simple pendulum of the length 2 L/3. Its tip is at x, y in plan, from the joint, z is up, and it stays below the
level of the joint. Friction is a moment against the turning; ``friction`` is this moment over the moment of inertia and the rate, 1/s.
"""

from dataclasses import replace

from ..harmonic import plane_oscillation
from ..ladders import Ladder, Rung
from ..models import Model, Neglected
from ..scalars import ZERO
from ..vectors import add3, scale3
from .foucault import any_swing as on_cord
from .foucault import below, held
from .low import STATES

PLACE = "place of the tip in plan, m"


def small(length, g):
    """Small swings without friction, an ellipse: states x, y, dx, dy of the tip.

    >>> small(3.0, 10.0).derivative((0.1, -0.2, 0.0, 0.2))
    (0.0, 0.2, -0.5, 1.0)
    """
    return Model("bar, small swings", {"length": length, "g": g}, STATES, _small, exact=_ellipse, neglects=(SIZE, FRICTION))


def small_with_friction(length, g, friction):
    """Small swings with friction, an ellipse that shrinks; friction is less than 2 sqrt(3 g/(2 length)), with which it creeps to rest."""
    parameters = {"length": length, "g": g, "friction": friction}
    return Model("bar, small swings with friction", parameters, STATES, _slowed, exact=_shrinking, neglects=(SIZE,))


def any_swing(length, g):
    """Any swing below the level of the joint, without friction: as the tip would swing on a cord, with gravity 3 g/2."""
    return replace(on_cord(length, 1.5 * g), name="bar, any swing", neglects=(FRICTION,))


def full(length, g, friction):
    """The same with friction: states x, y, dx, dy of the tip."""
    return Model("bar, any swing with friction", {"length": length, "g": g, "friction": friction}, STATES, _full)


def ladder(length=1.0, g=9.81, friction=0.02, start=(0.05, 0.0, 0.0, 0.1), t=5.0):
    """Four models: a :class:`~newton_euler.ladders.Ladder` for the place of the tip in plan, m, from the ``start`` x, y, dx, dy.

    >>> from newton_euler.ladders import smallest
    >>> for metres in (0.01, 0.001, 1e-5):
    ...     print(smallest(ladder(), metres).model.name)
    bar, small swings
    bar, small swings with friction
    bar, any swing with friction
    """
    models = small(length, g), small_with_friction(length, g, friction), any_swing(length, g), full(length, g, friction)
    return Ladder("spherical pendulum", PLACE, t, tuple(Rung(model, start, _place) for model in models))


def _place(s, p, t):
    return s.x, s.y


def _square(p):
    """Of the rate of small swings."""
    return 3 * p.g / (2 * p.length)


def _small(s, p, t):
    return s.dx, s.dy, -_square(p) * s.x, -_square(p) * s.y


def _ellipse(s, p, t):
    return plane_oscillation(s, _square(p), t)


def _slowed(s, p, t):
    return s.dx, s.dy, -_square(p) * s.x - p.friction * s.dx, -_square(p) * s.y - p.friction * s.dy


def _shrinking(s, p, t):
    return plane_oscillation(s, _square(p), t, p.friction)


def _full(s, p, t):
    r, v = below(s, p.length)
    return s.dx, s.dy, *held(r, v, add3((ZERO, ZERO, -3 * p.g / 2), scale3(-p.friction, v)), p.length)


SIZE = Neglected("the size of the swings", None, PLACE)
FRICTION = Neglected("the friction in the joint", None, PLACE)
