"""A body that rotates about a level shaft, with its dead weight (9.5), psi from the downward
vertical to the x axis of the body. For the bearings: :mod:`newton_euler.applications.rotors`.
"""

from collections.abc import Callable
from operator import attrgetter

from ...algebra.scalars import Scalar, cos, sin, sqrt
from ...motion.model import Model, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import constant_rate
from ..ladders import Ladder, Rung, observed_states

ANGLE = "angle psi, rad"
STATES = ("psi", "omega")


@scene(
    "9.5", "rotor", "a rotor with dead weight, started by a constant moment",
    8.0, (0.0, 0.0),
    mass=2.0, x=0.1, y=0.0, I=0.5, g=10.0, moment=2.5,
)  # fmt: skip
def turning_rotor(
    mass: Scalar, x: Scalar, y: Scalar, I: Scalar, g: Scalar, moment: Scalar | Callable = 0
) -> Model:
    """The Model of the rotation under a moment M about the shaft (9.10): states psi and omega.

    x, y, I : of G in the body; about the shaft; moment : a number or a law (s, p, t)

    >>> turning_rotor(2.0, 0.1, 0.0, 0.5, 10.0, moment=1.0).derivative((0.0, 3.0))
    (3.0, 2.0)
    """
    parameters, invariants = locals(), {} if callable(moment) else {"energy": _energy}
    return Model("rotor with dead weight", parameters, STATES, _rates, invariants)


@scene("9.5", "rotor", "constant rate, no weight, dead weight", ladder=True)
def ladder(
    mass: Scalar = 20.0, x: Scalar = 2e-4, y: Scalar = 0.0, I: Scalar = 0.5, g: Scalar = 9.81,
    moment: Scalar = 0.5, start: tuple[Scalar, ...] = (0.0, 10.0), t: Scalar = 20.0,
) -> Ladder:  # fmt: skip
    """The models of a rotor turned by a constant moment, for psi (rad) until ``t``.

    start : psi, omega; the rest as in :func:`turning_rotor`

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), radians).model.name for radians in (1000.0, 10.0, 1e-3)]
    ['rotor at a constant rate', 'rotor without weight', 'rotor with dead weight']
    """
    full = turning_rotor(mass, x, y, I, g, moment)
    name, given = "rotor at a constant rate", {**full.parameters, "omega": start[1]}
    steady = constant_rate(name, given, _steady, "psi", neglects=(MOMENT, WEIGHT))
    about = {"invariants": {"energy": _light_energy}, "neglects": (WEIGHT,)}
    light = constant_rate("rotor without weight", full.parameters, _light, *STATES, **about)
    rungs = (Rung(m, start[: len(m.states)], observed_states("psi")) for m in (steady, light, full))
    return Ladder("rotor", ANGLE, t, tuple(rungs))


_steady = attrgetter("omega")


def _light(p):
    return p.moment / p.I


def _light_energy(s, p, t):
    return p.I * s.omega**2 / 2 - p.moment * s.psi


def _rates(s, p, t):
    return s.omega, (p.moment - p.mass * p.g * (p.x * sin(s.psi) + p.y * cos(s.psi))) / p.I


def _energy(s, p, t):
    """Kinetic energy, less the works of weight and moment."""
    return _light_energy(s, p, t) - p.mass * p.g * (p.x * cos(s.psi) - p.y * sin(s.psi))


# -- bounds of what is neglected: at any angle the moment of the weight is at most m g d

MOMENT = Neglected(
    "the moment about the shaft",
    lambda s, p, t: sqrt(p.moment * p.moment) / p.I * (t * t) / 2,
    ANGLE,
)
WEIGHT = Neglected(
    "the dead weight",
    lambda s, p, t: p.mass * p.g * sqrt(p.x * p.x + p.y * p.y) / p.I * (t * t) / 2,
    ANGLE,
)
