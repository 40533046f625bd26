"""A rod, or any flat or slender body, hinged at the end of a vertical shaft that turns at a
constant rate (10.7).

theta is the angle from the *downward* vertical to the rod; ``weight_moment`` is m g d, d the
distance from the hinge to G, on the rod; ``inertia_difference`` is I_n - I_r about the hinge, of
the axis normal to both rod and hinge and of the rod (m L^2/3 for the rod itself).
"""

from dataclasses import replace
from math import copysign

from ...algebra.scalars import Scalar, acos, cos, is_numeric, max_abs, sin, sqrt, to_plain
from ...applications.gyroscopes import GyroError
from ...motion.model import Model, ModelError, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import growth, oscillation
from ..ladders import Ladder

ANGLE = "angle theta, rad"
STATES = ("theta", "theta_rate")


def rod(mass: Scalar, length: Scalar, omega: Scalar, g: Scalar) -> dict[str, Scalar]:
    """The parameters of the book's thin rod, for the functions below.

    >>> rod(3.0, 2.0, 4.0, 9.81)["inertia_difference"]
    4.0
    """
    return {
        "weight_moment": mass * g * length / 2,
        "inertia_difference": mass * (length * length) / 3,
        "omega": omega,
    }


def least_rate(weight_moment: Scalar, inertia_difference: Scalar, **_: Scalar) -> Scalar:
    """The rate sqrt(m g d/(I_n - I_r)) (rad/s) above which the body swings out; for the rod sqrt(3
    g/(2 L)). Up to it, hanging down is stable.

    >>> round(least_rate(**rod(3.0, 2.0, 4.0, 9.81)), 6)
    2.712471
    """
    return sqrt(weight_moment / inertia_difference)


def swing_out(
    weight_moment: Scalar, inertia_difference: Scalar, omega: Scalar, **_: Scalar
) -> Scalar:
    """The angle theta (rad) of relative equilibrium, for a rate above :func:`least_rate`: acos(m g
    d/((I_n - I_r) omega^2)), (10.31) with I = 0. Raises
    :class:`.GyroError` for a lower rate: then it hangs straight down.

    >>> round(swing_out(**rod(3.0, 2.0, 4.0, 9.81)), 6)
    1.092977
    """
    c = weight_moment / (inertia_difference * (omega * omega))
    if is_numeric(c) and max_abs(c) > 1:
        raise GyroError(
            f"at {omega} rad/s the body hangs straight down; it swings out above "
            f"{to_plain(least_rate(weight_moment, inertia_difference))} rad/s"
        )
    return acos(c)


def stiffness(
    theta: Scalar, weight_moment: Scalar, inertia_difference: Scalar, omega: Scalar,
    about_hinge: Scalar | None = None,
) -> Scalar:  # fmt: skip
    """The square of the angular frequency of small swings about theta, 0 or :func:`swing_out`,
    stable where it is positive: (m g d cos(theta) - (I_n - I_r) omega^2 cos(2 theta))/I_hinge;
    I_hinge is ``inertia_difference`` unless given.

    >>> [stiffness(0.0, **rod(3.0, 2.0, omega, 9.81)) > 0 for omega in (2.0, 4.0)]
    [True, False]
    """
    about_hinge = inertia_difference if about_hinge is None else about_hinge
    outward = inertia_difference * (omega * omega) * cos(2 * theta)
    return (weight_moment * cos(theta) - outward) / about_hinge


@scene(
    "10.7", "turning shaft", "a rod hinged on a turning shaft, which swings about its equilibrium",
    12.0, (0.2, 0.5),
    **rod(3.0, 2.0, 4.0, 9.81),
)  # fmt: skip
def hinged(
    weight_moment: Scalar, inertia_difference: Scalar, omega: Scalar,
    about_hinge: Scalar | None = None,
) -> Model:  # fmt: skip
    """The Model of swinging on a shaft at a constant rate: states theta and theta_rate; invariant
    the energy seen in the rotating frame.

    >>> hinged(**rod(3.0, 2.0, 4.0, 9.81)).derivative((0.0, 1.0))
    (1.0, 0.0)
    """
    about_hinge = inertia_difference if about_hinge is None else about_hinge
    return Model("hinged on a turning shaft", locals(), STATES, _rates, {"energy": _energy})


def on_free_shaft(
    weight_moment: Scalar, inertia_difference: Scalar, omega: Scalar, shaft: Scalar, theta: Scalar,
    about_hinge: Scalar | None = None,
) -> Model:  # fmt: skip
    """The Model of swinging on a shaft without moment, whose rate is ``omega`` when the angle is
    ``theta``: states as for :func:`hinged`. The angle of the shaft is cyclic, so that the angular
    ``momentum`` about the vertical is a parameter.

    shaft : moment of inertia about the vertical of all that rotates, for theta = 0

    >>> on_free_shaft(**rod(3.0, 2.0, 4.0, 9.81), shaft=1.0, theta=0.0).derivative((0.0, 1.0))
    (1.0, 0.0)
    """
    momentum = (shaft + inertia_difference * sin(theta) ** 2) * omega
    parameters = dict(hinged(weight_moment, inertia_difference, omega, about_hinge).parameters)
    del parameters["omega"]
    parameters |= {"momentum": momentum, "shaft": shaft}
    invariants = {"energy": _free_energy}
    return Model("hinged on a shaft let go", parameters, STATES, _free_rates, invariants)


@scene("10.7", "turning shaft", "small swings, any swings, a shaft that is let go", ladder=True)
def ladder(
    mass: Scalar = 3.0, length: Scalar = 2.0, omega: Scalar = 4.0, g: Scalar = 9.81,
    shaft: Scalar = 400.0, start: tuple[Scalar, ...] = (1.3, 0.0), t: Scalar = 4.0,
) -> Ladder:  # fmt: skip
    """The models of the thin rod, for theta (rad) until ``t``: small swings, any, a shaft let go.

    omega, shaft : the first rate of the shaft, and its inertia; start : theta, theta_rate
    Raises :class:`.ModelError` at :func:`least_rate` itself, where small swings are not harmonic.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), radians).model.name for radians in (0.1, 0.03, 1e-3)]
    ['small swings on a turning shaft', 'hinged on a turning shaft', 'hinged on a shaft let go']
    """
    data = rod(mass, length, omega, g)
    at = copysign(swing_out(**data), start[0]) if omega > least_rate(**data) else 0.0
    stiff = stiffness(at, **data)
    if not stiff > 0:
        raise ModelError(
            f"omega = {omega!r} is the least rate of swinging out: small swings have no rate there"
        )
    parameters = {**hinged(**data).parameters, "shaft": shaft, "rest": at, "stiffness": stiff}
    name, more = "small swings on a turning shaft", (_SMALL_ENERGY, _small_exact, (LARGE, EVEN))
    small = Model(name, parameters, STATES, _small, *more)
    even = replace(hinged(**data), parameters=parameters, neglects=(EVEN,))
    free = on_free_shaft(**data, shaft=shaft, theta=start[0])
    return Ladder.of_models("turning shaft", ANGLE, t, start, ("theta",), small, even, free)


def _small(s, p, t):
    return s.theta_rate, -p.stiffness * (s.theta - p.rest)


def _small_exact(s, p, t):
    x, rate = oscillation(s.theta - p.rest, s.theta_rate, p.stiffness, t)
    return p.rest + x, rate


_SMALL_ENERGY = {"energy": lambda s, p, t: s.theta_rate**2 + p.stiffness * (s.theta - p.rest) ** 2}


def _rates(s, p, t):
    return s.theta_rate, _acceleration(s, p, p.omega)


def _acceleration(s, p, omega):
    moment = p.inertia_difference * (omega * omega) * cos(s.theta) - p.weight_moment
    return sin(s.theta) * moment / p.about_hinge


def _energy(s, p, t):
    turning = p.inertia_difference * (p.omega * sin(s.theta)) ** 2
    return (p.about_hinge * s.theta_rate**2 - turning) / 2 - p.weight_moment * cos(s.theta)


def _free_rates(s, p, t):
    return s.theta_rate, _acceleration(s, p, p.momentum / _about_vertical(s, p))


def _about_vertical(s, p):
    return p.shaft + p.inertia_difference * sin(s.theta) ** 2


def _free_energy(s, p, t):
    turning = p.momentum**2 / _about_vertical(s, p)
    return (p.about_hinge * s.theta_rate**2 + turning) / 2 - p.weight_moment * cos(s.theta)


# -- bounds of what is neglected
#
# theta'' is a function of theta with a slope of at most L = ((I_n - I_r) omega^2 + m g d)/I_hinge
# and a second derivative of at most twice that. Two motions whose accelerations differ by ``more``
# at equal angles have a distance e with |e|'' <= L |e| + more: |e| <= more (cosh(sqrt(L) t) - 1)/L.


def _steepest(p):
    return (p.inertia_difference * (p.omega * p.omega) + p.weight_moment) / p.about_hinge


def _apart(p, more, t):
    return more * growth(sqrt(_steepest(p)), t)[2]


def _by_large(s, p, t):
    """Small swings keep their amplitude; they leave at most a parabola out of the acceleration."""
    x = s.theta - p.rest
    return _apart(p, _steepest(p) * (x * x + s.theta_rate * s.theta_rate / p.stiffness), t)


def _by_even(s, p, t):
    """The rate of the shaft lies between 1/(1 + q) and 1 + q times that at the start."""
    q = p.inertia_difference / p.shaft
    most = p.inertia_difference * (p.omega * p.omega) / (2 * p.about_hinge)
    return _apart(p, most * q * (2 + q), t)


LARGE = Neglected("that the swings are not small", _by_large, ANGLE)
EVEN = Neglected("the change of the rate of the shaft", _by_even, ANGLE)
