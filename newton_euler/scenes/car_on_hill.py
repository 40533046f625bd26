"""A car that accelerates up a hill, and what its engine must give (11.19)."""

from dataclasses import dataclass

from ..models import Model
from ..scalars import plain, scalar, sin
from ..work import summed


@dataclass(frozen=True)
class Car:
    """A car on wheels that roll without slipping.

    m : mass of the whole car, wheels included; wheel_mass, gyration, radius : of each wheel, its radius of gyration about the axle and its radius
    drag : the force of the air (and whatever else a tow rope feels on the level) as a function of the speed; g : gravity

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
        """T at the speed v, an Amount with the terms ``translation`` and ``wheels`` (11.45), (11.48)."""
        terms = {"translation": scalar(self.m) * v * v / 2, "wheels": self._wheels() * v * v / 2}
        return summed(terms, "kinetic energy", "11.45")

    def powers(self, v, a, slope):
        """The power at the wheels, an Amount in W with what it is for: ``accelerate``, ``wheels``, ``climb``, ``air``.

        v, a : speed and acceleration; slope : inclination of the road, rad, positive uphill. It is the rate of (11.48).
        """
        terms = {"accelerate": scalar(self.m) * v * a, "wheels": self._wheels() * v * a}
        terms |= {"climb": scalar(self.m) * self.g * v * sin(slope), "air": scalar(self.drag(v)) * v}
        return summed(terms, "power", "rate of 11.48")

    def power(self, v, a, slope):
        """The power at the wheels, W: the sum of :meth:`powers`."""
        return self.powers(v, a, slope).value

    def acceleration(self, power, v, slope):
        """The acceleration at the speed v (not zero) that this power gives: :meth:`powers` solved for a."""
        left = scalar(power) - scalar(self.m) * self.g * v * sin(slope) - scalar(self.drag(v)) * v
        return plain(left / ((self.m + self._wheels()) * v))

    def model(self, power, slope):
        """The motion up a hill as a Model with the states s, the way, and v; ``power`` and ``slope`` numbers or laws (s, p, t)."""
        return Model("car on a hill", {"power": power, "slope": slope}, ("s", "v"), lambda s, p, t: (s.v, self.acceleration(p.power, s.v, p.slope)))

    def _wheels(self):
        """What the rotation of the wheels adds to the mass: their moments of inertia over radius^2."""
        ratio = scalar(self.gyration) / self.radius
        return self.wheels * self.wheel_mass * (ratio * ratio)
