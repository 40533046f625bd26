"""How small a pendulum, and how small a swing: the rigid pendulum (11.17) as a ladder, from the harmonic oscillator to the body.

The particle needs no more calculation than the body but less to be known: not I, the moment of inertia about the centre of mass.
"""

import math
from dataclasses import replace

from ..harmonic import growth, oscillation
from ..ladders import Ladder, Rung
from ..models import Model, Neglected
from ..scalars import asin, scalar, sin, sqrt, where
from .physical_pendulum import physical_pendulum

ANGLE = "angle, rad"


def small_swings(m, I, l, g):
    """The body at small angles, exactly: a harmonic oscillator; states as for :func:`~newton_euler.scenes.physical_pendulum.physical_pendulum`.

    >>> small_swings(2.0, 0.5, 0.5, 10.0).derivative((0.1, 0.0))
    (0.0, -1.0)
    """
    return Model("pendulum, small swings", {"m": m, "I": I, "l": l, "g": g}, ("theta", "omega"), _rates, exact=_exact, neglects=(SINE,))


def particle(m, l, g, I=0):
    """The whole mass at the distance l from the axis: the mathematical pendulum. I serves to bound what it neglects."""
    size = Neglected("the moment of inertia about the centre of mass", lambda s, p, t: _by_size(s, p, t, scalar(I)), ANGLE)
    return replace(physical_pendulum(m, 0, l, g), name="pendulum, a particle", neglects=(size,))


def ladder(m=1.0, I=0.002, l=1.0, g=9.81, start=(0.3, 0.0), t=10.0):
    """Small swings, a particle, a body: a :class:`~newton_euler.ladders.Ladder` for theta in rad, until ``t`` after the start (theta, omega).

    >>> from newton_euler.ladders import smallest
    >>> [smallest(ladder(), angle).model.name for angle in (0.1, 0.01, 0.001)]
    ['pendulum, small swings', 'pendulum, a particle', 'physical pendulum']
    """
    models = small_swings(m, I, l, g), particle(m, l, g, I), physical_pendulum(m, I, l, g)
    return Ladder("physical pendulum", ANGLE, t, tuple(Rung(model, start, _theta) for model in models))


def _theta(s, p, t):
    return (s.theta,)


def _square(m, I, l, g):
    """Of the rate of small swings."""
    return m * g * l / (I + m * l * l)


def _rates(s, p, t):
    return s.omega, -_square(p.m, p.I, p.l, p.g) * s.theta


def _exact(s, p, t):
    return oscillation(s.theta, s.omega, _square(p.m, p.I, p.l, p.g), t)


# -- what may be neglected


def _by_sine(s, p, t):
    """A swing of the amplitude A has |theta - sin(theta)| <= A^3/6 all the time, which pushes an oscillator by at most n t A^3/6."""
    n = sqrt(_square(p.m, p.I, p.l, p.g))
    high = sin(s.theta / 2) ** 2 + (s.omega / (2 * n)) ** 2  # sin^2(A/2)
    swings = where(high < 1, abs(s.theta) < 3.14, False)
    amplitude = 2 * asin(sqrt(where(swings, high, 0)))
    return where(swings, n * t * amplitude**3 / 6, math.inf)


def _by_size(s, p, t, I):
    """Let go at rest, the body does what the particle does, but slower. Pushed, it moves away no faster than from the upper resting place."""
    n, slower = sqrt(p.g / p.l), sqrt(_square(p.m, I, p.l, p.g))
    at_rest = (n - slower) * t * 2 * sin(abs(s.theta) / 2)
    pushed = (n * n - slower * slower) * growth(n, t)[2]
    return where(s.omega == 0, at_rest, pushed)


SINE = Neglected("the difference between an angle and its sine", _by_sine, ANGLE)
