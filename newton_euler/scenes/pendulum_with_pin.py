"""A ball on a cord that meets a pin when it hangs straight down, and swings on about the pin on the rest of the cord (11.8, 11.12)."""

from dataclasses import dataclass

from ..energy import speed_after
from ..potential import weight_potential
from ..scalars import cos, pi, scalar, sin
from ..work import summed, work_integral


@dataclass(frozen=True)
class PendulumWithPin:
    """Released at A, at ``angle`` (rad, below a right angle) from the downward vertical, with the speed ``v0``; C is level with the pin.

    length : of the cord; pin : distance of the pin straight below the support; g : gravity
    The mass drops out, so that work and energy here are those of a unit of mass. The cord does no work: it is normal to the path.

    >>> import math
    >>> ball = PendulumWithPin(length=0.9, pin=0.6, angle=math.radians(60), v0=2.0, g=9.81)
    >>> round(ball.speed_at_bottom(), 3), round(ball.speed_at_pin(), 3)
    (3.582, 2.635)
    """

    length: object
    pin: object
    angle: object
    v0: object
    g: object

    def works(self, exact=False):
        """The works of the weight on the two arcs, of its tangential component over their length (11.3); exact=True: by SymPy."""
        rest = scalar(self.length) - self.pin
        down = work_integral(lambda a: self.g * sin(a) * self.length, 0 * self.angle, self.angle, exact=exact)
        rising = work_integral(lambda a: -(self.g * sin(a)) * rest, 0, pi(self.angle) / 2 + 0 * self.angle, exact=exact)
        return summed({"A to the bottom": down, "bottom to C": rising}, number="11.3", error=down.error + rising.error)

    def energy(self, depth, speed):
        """T + V of a unit of mass at this depth below the support (11.30), (11.34): the same all along."""
        return summed({"kinetic": scalar(speed) * speed / 2, "potential": weight_potential(1, -scalar(depth), self.g)}, "energy", "11.30")

    def speed_at(self, depth):
        """The speed at this depth below the support, on either arc: v^2 = v0^2 + 2 g (depth - depth of A) (11.4), (11.32)."""
        return speed_after(self.v0, self.g * (depth - self.length * cos(self.angle)), 1)

    def speed_at_bottom(self):
        """The speed at the lowest place, as the cord meets the pin; it does not change there, since the pin pulls across the path."""
        return self.speed_at(self.length)

    def speed_at_pin(self):
        """The speed at C, straight up. :class:`~newton_euler.energy.EnergyError` if the ball does not get there."""
        return self.speed_at(self.pin)
