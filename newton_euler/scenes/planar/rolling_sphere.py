"""A sphere, or another round body, that rolls down an incline without slipping (11.15). One that
slides first: :mod:`newton_euler.scenes.planar.sliding_sphere`.

``k`` is the moment of inertia about the centre over m R^2: 2/5 for a solid sphere (the default),
2/3 for a shell, 1/2 for a cylinder.

:func:`ladder` has three models of it: a block that slides without friction, rolling, and rolling
against the air. The block needs no less calculation than the sphere, but no moment of inertia.
"""

from ...algebra.ledger import summed
from ...algebra.scalars import plain, radians, scalar, sin, tan, whole
from ...dynamics.energy import speed_after
from ...motion.model import Model, ModelError, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import integrated_square, uniform_acceleration
from ..ladders import Ladder

WAY = "distance down the incline, m"
STATES = ("x", "v")


def rolling_energy(m, R, speed, pivoting=0, k=None):
    """T of the rolling body with terms ``translation``, ``rolling`` and ``pivoting`` (11.45): 7/10
    m v^2 for a sphere that does not pivot.

    pivoting : the component of omega along the normal of the plane, rad/s, which the book takes to
        be zero. Rolling does not change it: for a sphere it only adds a constant.

    >>> round(rolling_energy(2.0, 0.5, 3.0).value, 9)
    12.6
    """
    k, translation = _ratio(m, k), scalar(m) * speed * speed / 2
    spun = k * (scalar(m) * R * R) * (scalar(pivoting) * pivoting) / 2
    return summed(
        {"translation": translation, "rolling": k * translation, "pivoting": spun},
        "kinetic energy",
        "11.45",
    )


def rolling_speed(drop, g, v0=0, k=None):
    """The speed of the centre after a descent by ``drop``: sqrt(v0^2 + 2 g h/(1 + k)), from rest
    sqrt(10 g h/7) for a sphere (11.49).

    The contact is at rest, so its force does no work; without rolling it would be sqrt(2 g h), on
    any incline.

    >>> round(rolling_speed(0.7, 10.0), 9)
    3.16227766
    """
    return speed_after(v0, scalar(g) * drop, 1 + _ratio(g, k))


@scene(
    "11.15",
    "sphere on an incline",
    "a sphere that rolls down a plane of 30 degrees",
    2.0,
    (1.0, 0.5),
    slope=radians(30.0),
    g=9.8,
)
def rolling_down(slope, g, k=None):
    """The motion straight down a plane of inclination ``slope``: a Model with the states x (down
    the plane) and v, and the energy over mass kept.

    It rolls if the friction can be :func:`friction_needed` times the normal force; as the slope
    nears the vertical, that has no bound.

    >>> rolling_down(0.5235987755982988, 9.8).derivative((0.0, 0.0))[1]
    3.5
    """
    k = _ratio(g, k)
    return Model(
        "sphere on an incline", locals(), STATES, _rates, {"energy over mass": _energy}, _exact
    )


def rolling_in_air(slope, g, air, k=None):
    """The same against the air, which resists with ``air`` m v^2; air (1/m) is rho C_D A/(2 m). For
    a sphere that comes down: v is not negative.

    The closed form (1 + k)/air log(cosh(n t) + ...) is not used: with little air it is the
    logarithm of almost 1, in which all digits cancel.

    >>> rolling_in_air(0.5235987755982988, 9.8, 0.01).derivative((0.0, 7.0))[1]
    3.15
    """
    k = _ratio(g, k)
    return Model("sphere on an incline, in air", locals(), STATES, _air_rates)


@scene(
    "11.15",
    "sphere on an incline",
    "a block that slides without friction, rolling, rolling in air",
    ladder=True,
)
def ladder(slope=0.3, g=9.81, air=2e-3, k=0.4, start=(0.0, 0.0), t=5.0):
    """The models of one run, the coarsest first: a :class:`~newton_euler.scenes.ladders.Ladder` for
    the distance, in m, until ``t``.

    air : not negative; start : x, v. Raises :class:`~newton_euler.motion.model.ModelError` for a
        sphere that goes uphill.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (20.0, 1.0, 0.01)]
    ['block on an incline', 'sphere on an incline', 'sphere on an incline, in air']
    """
    if start[1] < 0:
        raise ModelError(
            f"the ladder is for a sphere that comes down, v not below zero; got v = {start[1]!r}"
        )
    full = rolling_in_air(slope, g, air, k)
    block = Model(
        "block on an incline",
        full.parameters,
        STATES,
        _block_rates,
        {"energy over mass": _block_energy},
        _block_exact,
        (ROTATION, AIR),
    )
    sphere = Model(
        "sphere on an incline",
        full.parameters,
        STATES,
        _rates,
        {"energy over mass": _energy},
        _exact,
        (AIR,),
    )
    return Ladder.of_models("sphere on an incline", WAY, t, start, ("x",), block, sphere, full)


def friction_needed(slope, k=None):
    """Friction over normal force of the rolling body: k tan(slope)/(1 + k); with less, it slips.

    >>> round(friction_needed(0.7853981633974483), 6)
    0.285714
    """
    k = _ratio(slope, k)
    return plain(k * tan(slope) / (1 + k))


def _acceleration(p):
    return p.g * sin(p.slope) / (1 + p.k)


def _block_rates(s, p, t):
    return s.v, p.g * sin(p.slope)


def _block_exact(s, p, t):
    return uniform_acceleration(s.x, s.v, p.g * sin(p.slope), t)


def _block_energy(s, p, t):
    return s.v * s.v / 2 - p.g * sin(p.slope) * s.x


def _rates(s, p, t):
    return s.v, _acceleration(p)


def _exact(s, p, t):
    return uniform_acceleration(s.x, s.v, _acceleration(p), t)


def _energy(s, p, t):
    return (1 + p.k) * s.v * s.v / 2 - p.g * sin(p.slope) * s.x


def _air_rates(s, p, t):
    return s.v, _acceleration(p) - p.air / (1 + p.k) * s.v * s.v


# -- what may be neglected: against the air the sphere is never faster than without it


def _by_rotation(s, p, t):
    return p.g * sin(p.slope) * p.k / (1 + p.k) * (t * t) / 2


def _by_air(s, p, t):
    return p.air / (1 + p.k) * integrated_square(s.v, _acceleration(p), t)


ROTATION = Neglected("the moment of inertia", _by_rotation, WAY)
AIR = Neglected("the resistance of the air", _by_air, WAY)


def _ratio(like, k):
    return whole(2, like) / 5 if k is None else k
