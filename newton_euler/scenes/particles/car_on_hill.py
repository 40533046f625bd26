"""A car that accelerates up a hill, and what its engine must give (11.19).

:func:`ladder` has three models of its motion under a constant force: a particle, a car on wheels,
and that against the air. The particle needs no less calculation than the car on wheels, but less to
be known.
"""

from dataclasses import dataclass
from math import inf

from ...algebra.ledger import summed
from ...algebra.scalars import atan, plain, scalar, sin, sqrt
from ...motion.model import Model, ModelError, Named, Neglected
from ..catalogue import scene
from ..closed_forms.harmonic import integrated_square, uniform_acceleration
from ..ladders import Ladder

WAY = "distance up the hill, m"
STATES = ("s", "v")


@dataclass(frozen=True)
class Car:
    """A car on wheels that roll without slipping.

    m : mass of the whole car, wheels included; wheel_mass, gyration, radius : of each wheel, its
        radius of gyration about the axle and its radius
    drag : the resistance on the level, of the air and the wheels, as a function of the speed; g :
        gravity

    >>> car = Car(m=1200.0, wheel_mass=20.0, gyration=0.25, radius=0.3, drag=lambda v: 0.5*v*v, g=9.81)
    >>> round(car.power(20.0, 1.0, 0.0), 1)
    29111.1
    """

    m: object
    wheel_mass: object
    gyration: object
    radius: object
    drag: object
    g: object
    wheels: int = 4

    def kinetic_energy(self, v):
        """T at the speed v, an Amount with the terms ``translation`` and ``wheels`` (11.45),
        (11.48).
        """
        terms = {"translation": scalar(self.m) * v * v / 2, "wheels": self._wheels() * v * v / 2}
        return summed(terms, "kinetic energy", "11.45")

    def powers(self, v, a, slope):
        """The power at the wheels, an Amount in W with what it is for: ``accelerate``, ``wheels``,
        ``climb``, ``air``.

        v, a : speed and acceleration; slope : inclination of the road, rad, positive uphill. It is
            the rate of (11.48).
        """
        terms = {"accelerate": scalar(self.m) * v * a, "wheels": self._wheels() * v * a}
        terms |= {
            "climb": scalar(self.m) * self.g * v * sin(slope),
            "air": scalar(self.drag(v)) * v,
        }
        return summed(terms, "power", "rate of 11.48")

    def power(self, v, a, slope):
        """The power at the wheels, W: the sum of :meth:`powers`."""
        return self.powers(v, a, slope).value

    def acceleration(self, power, v, slope):
        """The acceleration at the speed v (not zero) that this power gives: :meth:`powers` solved
        for a.
        """
        left = scalar(power) - scalar(self.m) * self.g * v * sin(slope) - scalar(self.drag(v)) * v
        return plain(left / ((self.m + self._wheels()) * v))

    def model(self, power, slope):
        """The motion up a hill as a Model with the states s, the distance, and v; ``power`` and
        ``slope`` numbers or laws (s, p, t).
        """
        return Model(
            "car on a hill",
            {"power": power, "slope": slope},
            ("s", "v"),
            lambda s, p, t: (s.v, self.acceleration(p.power, s.v, p.slope)),
        )

    def _wheels(self):
        """What the rotation of the wheels adds to the mass: their moments of inertia over radius^2."""
        return _wheels(self)


@scene("11.19", "car on a hill", "a car of constant power over wavy ground", 60.0, (0.0, 10.0))
def _on_waves():
    return Car(1200.0, 20.0, 0.25, 0.3, lambda v: 0.5 * v * v, 9.81).model(
        40e3, lambda s, p, t: 0.08 * sin(s.s / 64)
    )


def _wheels(p):
    ratio = scalar(p.gyration) / p.radius
    return p.wheels * p.wheel_mass * (ratio * ratio)


@scene("11.19", "car on a hill", "a particle, a car on wheels, air", ladder=True)
def ladder(
    m=1200.0,
    wheel_mass=20.0,
    gyration=0.25,
    radius=0.3,
    air=0.4,
    g=9.81,
    force=2500.0,
    slope=0.08,
    start=(0.0, 10.0),
    t=10.0,
):
    """The models of one start, the coarsest first: a :class:`~newton_euler.scenes.ladders.Ladder`
    for the distance, in m, until ``t``.

    force : at the wheels, the power over the speed, as one gear gives it; air : rho C_D A/2, kg/m;
        start : s, v; the rest as in :class:`Car`.
    Raises :class:`~newton_euler.motion.model.ModelError` for a car that comes to rest before ``t``.
    The fullest model has no closed form that would hold whether the force is larger or smaller than
    the weight's part.

    >>> from newton_euler import smallest
    >>> [smallest(ladder(), metres).model.name for metres in (10.0, 5.0, 0.1)]
    ['car, particle', 'car on wheels', 'car on wheels, in air']
    """
    parameters = {
        "m": m,
        "wheel_mass": wheel_mass,
        "gyration": gyration,
        "radius": radius,
        "wheels": 4,
    }
    parameters |= {"air": air, "g": g, "force": force, "slope": slope}
    particle = Model(
        "car, particle", parameters, STATES, _particle_rates, {}, _particle_exact, (WHEELS, AIR)
    )
    wheels = Model("car on wheels", parameters, STATES, _wheel_rates, {}, _wheel_exact, (AIR,))
    if start[1] < 0 or _stops(Named("parameter", parameters), start[1]) < t:
        raise ModelError(
            f"the ladder is for a car that goes uphill until t = {t!r}; with {force!r} N and v "
            f"= {start[1]!r} it does not"
        )
    return Ladder.of_models(
        "car on a hill",
        WAY,
        t,
        start,
        ("s",),
        particle,
        wheels,
        Model("car on wheels, in air", parameters, STATES, _air_rates),
    )


def _stops(p, v):
    """The time at which the car comes to rest; inf if it does not."""
    held, mass = -_left(p), p.m + _wheels(p)
    if held <= 0:
        return inf
    return mass * atan(v * sqrt(p.air / held)) / sqrt(p.air * held) if p.air else mass * v / held


def _left(p):
    """The resultant force along the slope, without the air."""
    return p.force - p.m * p.g * sin(p.slope)


def _particle_rates(s, p, t):
    return s.v, _left(p) / p.m


def _particle_exact(s, p, t):
    return uniform_acceleration(s.s, s.v, _left(p) / p.m, t)


def _wheel_rates(s, p, t):
    return s.v, _left(p) / (p.m + _wheels(p))


def _wheel_exact(s, p, t):
    return uniform_acceleration(s.s, s.v, _left(p) / (p.m + _wheels(p)), t)


def _air_rates(s, p, t):
    return s.v, (_left(p) - p.air * s.v * s.v) / (p.m + _wheels(p))


# -- what may be neglected: against the air the car is never faster than without it


def _by_wheels(s, p, t):
    left = _left(p)
    return sqrt(left * left) / p.m * _wheels(p) / (p.m + _wheels(p)) * (t * t) / 2


def _by_air(s, p, t):
    left, mass = _left(p), p.m + _wheels(p)
    return p.air / mass * integrated_square(s.v, sqrt(left * left) / mass, t)


WHEELS = Neglected("the moments of inertia of the wheels", _by_wheels, WAY)
AIR = Neglected("the resistance of the air", _by_air, WAY)
