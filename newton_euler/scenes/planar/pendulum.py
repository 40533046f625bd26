"""A rigid body that swings about a level axis: the physical pendulum (11.17). m mass, I moment of
inertia about the parallel to the axis through G, l distance of G from the axis, theta from below.
"""

import math
from dataclasses import replace
from functools import partial

from ...algebra.scalars import Scalar, asin, cos, scalar, sin, sqrt, where
from ...motion.model import Model, Neglected, comparable
from ..catalogue import scene
from ..closed_forms.elliptic import coupled, unwrapped
from ..closed_forms.harmonic import growth, oscillation
from ..ladders import Ladder

ANGLE = "angle, rad"
STATES = ("theta", "omega")


@scene(
    "11.17", "pendulum", "a rigid pendulum, swinging by 1 rad",
    10.0, (1.0, 0.0), m=2.0, I=0.5, l=0.5, g=10.0,
)  # fmt: skip
@scene(
    "11.17", "pendulum, over the top", "a rigid pendulum released near the upright position",
    15.0, (3.1, 0.0), m=2.0, I=0.5, l=0.5, g=10.0,
)  # fmt: skip
def physical_pendulum(m: Scalar, I: Scalar, l: Scalar, g: Scalar) -> Model:
    """The Model of the pendulum: states theta and omega; the energy (11.32) is an invariant.

    The exact solution counts theta through all turns. It is exact for a start within a few
    round-offs of the given one, and right to a few round-offs of t times the rate of the motion:
    where the pendulum only just reaches the upright, small differences of the start grow.

    >>> swing = physical_pendulum(2.0, 0.5, 0.5, 10.0)
    >>> swing.derivative((1.5707963267948966, 0.0))
    (0.0, -10.0)
    >>> [round(x, 6) for x in swing.solution(10.0, (0.0, 6.5))]  # over the top, several times
    [34.990743, 2.024268]
    """
    return Model("physical pendulum", locals(), STATES, _rates, {"energy": _energy}, _exact)


def _square(p, I):
    """The square of the angular frequency of small swings."""
    return p.m * p.g * p.l / _inertia(p, I)


def _inertia(p, I):
    return I + p.m * p.l * p.l


def _rates(s, p, t):
    return s.omega, -(_square(p, p.I) * sin(s.theta))


def _energy(s, p, t):
    return _inertia(p, p.I) * s.omega**2 / 2 - p.m * p.g * p.l * cos(s.theta)


def _exact(s, p, t):
    """cos(theta/2), sin(theta/2) and omega/2 change at rates that are products of the others; with
    g or l negative, sine and cosine change places.
    """
    theta, omega, k, t = comparable("pendulum", s.theta, s.omega, _square(p, p.I), t)
    half, upright = theta / 2, k < 0
    start = cos(half), sin(half)
    x, y = where(upright, start[1], start[0]), where(upright, start[0], start[1])
    one = where(upright, 1, -1)
    gap = abs(k) * (x * x) - (omega / 2) * (omega / 2)
    x, y, rate, phase = coupled((one, -one, one * abs(k)), (x, y, omega / 2), gap, t)
    now = where(upright, y, x), where(upright, x, y)
    turns = where(gap > 0, 0, where(omega < 0, -phase, phase))
    return 2 * unwrapped(half, start, now, turns), 2 * rate


def small_swings(m: Scalar, I: Scalar, l: Scalar, g: Scalar) -> Model:
    """The Model of small angles, a harmonic oscillator; states as for :func:`physical_pendulum`.

    >>> small_swings(2.0, 0.5, 0.5, 10.0).derivative((0.1, 0.0))
    (0.0, -1.0)
    """
    return Model("pendulum, small swings", locals(), STATES, _small, {}, _small_exact, (SINE,))


def particle(m: Scalar, l: Scalar, g: Scalar, I: Scalar = 0) -> Model:
    """The Model of the mathematical pendulum, with the whole mass at the distance l from the axis.
    I only serves the bound of what it neglects.

    >>> particle(2.0, 0.5, 10.0).derivative((1.5707963267948966, 0.0))
    (0.0, -20.0)
    """
    what, bound = "the moment of inertia about the centre of mass", partial(_by_size, scalar(I))
    neglects = (Neglected(what, bound, ANGLE),)
    return replace(physical_pendulum(m, 0, l, g), name="pendulum, a particle", neglects=neglects)


@scene("11.17", "physical pendulum", "small swings, a particle, a rigid body", ladder=True)
def ladder(
    m: Scalar = 1.0, I: Scalar = 0.002, l: Scalar = 1.0, g: Scalar = 9.81,
    start: tuple[Scalar, ...] = (0.3, 0.0), t: Scalar = 10.0,
) -> Ladder:  # fmt: skip
    """The models small swings, particle and body, for theta (rad) until ``t`` after (theta, omega).

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), angle).model.name for angle in (0.1, 0.01, 0.001)]
    ['pendulum, small swings', 'pendulum, a particle', 'physical pendulum']
    """
    models = small_swings(m, I, l, g), particle(m, l, g, I), physical_pendulum(m, I, l, g)
    return Ladder.of_models("physical pendulum", ANGLE, t, start, ("theta",), *models)


def _small(s, p, t):
    return s.omega, -_square(p, p.I) * s.theta


def _small_exact(s, p, t):
    return oscillation(s.theta, s.omega, _square(p, p.I), t)


# -- bounds of what is neglected


def _by_sine(s, p, t):
    """At the amplitude A, |theta - sin(theta)| <= A^3/6 moves an oscillator by n t A^3/6."""
    n = sqrt(_square(p, p.I))
    high = sin(s.theta / 2) ** 2 + (s.omega / (2 * n)) ** 2  # sin^2(A/2)
    swings = where(high < 1, abs(s.theta) < 3.14, False)
    amplitude = 2 * asin(sqrt(where(swings, high, 0)))
    return where(swings, n * t * amplitude**3 / 6, math.inf)


def _by_size(I, s, p, t):
    """From rest the body is only slower than the particle; pushed, they diverge fastest upright."""
    n, slower = sqrt(p.g / p.l), sqrt(_square(p, I))
    at_rest = (n - slower) * t * 2 * sin(abs(s.theta) / 2)
    pushed = (n * n - slower * slower) * growth(n, t)[2]
    return where(s.omega == 0, at_rest, pushed)


SINE = Neglected("the difference between an angle and its sine", _by_sine, ANGLE)
