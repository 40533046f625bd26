"""A sphere, or another round body, that rolls down an incline without slipping (11.15); for one
that slides first see :mod:`newton_euler.scenes.planar.sliding_sphere`.

``k`` is the moment of inertia about the centre over m R^2: 2/5 for a solid sphere (the default),
2/3 for a shell, 1/2 for a cylinder.
"""

from dataclasses import replace

from ...algebra.scalars import Scalar, integer_like, radians, sin
from ...motion.model import Model, ModelError, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import constant_rate, integrated_square
from ..ladders import Ladder

WAY = "distance down the incline, m"
STATES = ("x", "v")


@scene(
    "11.15", "sphere on an incline", "a sphere that rolls down a plane of 30 degrees",
    2.0, (1.0, 0.5), slope=radians(30.0), g=9.8,
)  # fmt: skip
def rolling_down(slope: Scalar, g: Scalar, k: Scalar | None = None) -> Model:
    """The Model of rolling straight down a plane of inclination ``slope`` (rad): states x, down the
    plane, and v; invariant the energy over mass. It needs a friction of k tan(slope)/(1 + k) times
    the normal force.

    >>> rolling_down(0.5235987755982988, 9.8).derivative((0.0, 0.0))[1]
    3.5
    """
    name, parameters = "sphere on an incline", {"slope": slope, "g": g, "k": inertia_ratio(g, k)}
    return constant_rate(name, parameters, _rolling, *STATES, invariants=_INVARIANTS)


def rolling_in_air(slope: Scalar, g: Scalar, air: Scalar, k: Scalar | None = None) -> Model:
    """The Model of rolling down against a drag ``air`` m v^2; air (1/m) is rho C_D A/(2 m); v >= 0.

    The closed form (1 + k)/air log(cosh(n t) + ...) is not used: with little air it is the
    logarithm of almost 1, in which all digits cancel.

    >>> rolling_in_air(0.5235987755982988, 9.8, 0.01).derivative((0.0, 7.0))[1]
    3.15
    """
    k = inertia_ratio(g, k)
    return Model("sphere on an incline, in air", locals(), STATES, _air_rates)


@scene(
    "11.15", "sphere on an incline",
    "a block that slides without friction, rolling, rolling in air", ladder=True,
)  # fmt: skip
def ladder(
    slope: Scalar = 0.3, g: Scalar = 9.81, air: Scalar = 2e-3, k: Scalar = 0.4,
    start: tuple[Scalar, ...] = (0.0, 0.0), t: Scalar = 5.0,
) -> Ladder:  # fmt: skip
    """The models of one run, for the distance (m) until ``t``: a sliding block, rolling, in air.

    air : not negative; start : x, v; :class:`.ModelError` if it goes uphill

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (20.0, 1.0, 0.01)]
    ['block on an incline', 'sphere on an incline', 'sphere on an incline, in air']
    """
    if (v := start[1]) < 0:
        raise ModelError(f"the ladder is for a sphere that comes down, v >= 0; got v = {v!r}")
    full = rolling_in_air(slope, g, air, k)
    about = {"invariants": _BLOCK_INVARIANTS, "neglects": (ROTATION, AIR)}
    block = constant_rate("block on an incline", full.parameters, _sliding, *STATES, **about)
    sphere = replace(rolling_down(slope, g, k), parameters=full.parameters, neglects=(AIR,))
    return Ladder.of_models("sphere on an incline", WAY, t, start, ("x",), block, sphere, full)


def inertia_ratio(like: Scalar, k: Scalar | None) -> Scalar:
    """``k``, or if it is None that of a solid sphere, 2/5 in the kind of number of ``like``."""
    return integer_like(2, like) / 5 if k is None else k


def _sliding(p):
    return p.g * sin(p.slope)


def _rolling(p):
    return _sliding(p) / (1 + p.k)


def _air_rates(s, p, t):
    return s.v, _rolling(p) - p.air / (1 + p.k) * s.v * s.v


_BLOCK_INVARIANTS = {"energy over mass": lambda s, p, t: s.v * s.v / 2 - _sliding(p) * s.x}
_INVARIANTS = {"energy over mass": lambda s, p, t: (1 + p.k) * s.v * s.v / 2 - _sliding(p) * s.x}

# -- bounds of what is neglected: against the air the sphere is never faster than without it

ROTATION = Neglected("the moment of inertia", lambda s, p, t: _rolling(p) * p.k * (t * t) / 2, WAY)
AIR = Neglected(
    "the resistance of the air",
    lambda s, p, t: p.air / (1 + p.k) * integrated_square(s.v, _rolling(p), t),
    WAY,
)
