"""Worked examples of chapter 11, work and energy: a pendulum that meets a pin (11.8, 11.12),
gravitational attraction (11.10).
"""

from dataclasses import dataclass

from newton_euler import cos, pi, sin, sqrt
from newton_euler.algebra.ledger import summed
from newton_euler.algebra.scalars import plain, scalar
from newton_euler.dynamics.energy import speed_after
from newton_euler.dynamics.potential import weight_potential
from newton_euler.dynamics.work import work_integral


@dataclass(frozen=True)
class PendulumWithPin:
    """A ball on a cord that meets a pin when it hangs straight down, and swings on about the pin on
    the rest of the cord (11.8, 11.12).

    Released at A, at ``angle`` (rad, less than a right angle) from the downward vertical, with the
    speed ``v0``; C is level with the pin.
    length : of the cord; pin : distance of the pin straight below the support; g : gravity. Any
        consistent units.
    Work and energy are those of a unit mass. The cord does no work: it is normal to the path.

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
        """The works of the weight on the two arcs, of its tangential component over their length
        (11.3); exact=True: by SymPy.
        """
        rest = scalar(self.length) - self.pin
        down = work_integral(
            lambda a: self.g * sin(a) * self.length, 0 * self.angle, self.angle, exact=exact
        )
        rising = work_integral(
            lambda a: -(self.g * sin(a)) * rest, 0, pi(self.angle) / 2 + 0 * self.angle, exact=exact
        )
        return summed(
            {"A to the bottom": down, "bottom to C": rising},
            number="11.3",
            error=down.error + rising.error,
        )

    def energy(self, depth, speed):
        """T + V of a unit mass at this depth below the support (11.30), (11.34): constant during
        the motion.
        """
        return summed(
            {
                "kinetic": scalar(speed) * speed / 2,
                "potential": weight_potential(1, -scalar(depth), self.g),
            },
            "energy",
            "11.30",
        )

    def speed_at(self, depth):
        """The speed at this depth below the support, on either arc: v^2 = v0^2 + 2 g (depth - depth
        of A) (11.4), (11.32).
        """
        return speed_after(self.v0, self.g * (depth - self.length * cos(self.angle)), 1)

    def speed_at_bottom(self):
        """The speed at the lowest point, as the cord meets the pin; it does not change there, since
        the pin pulls at right angles to the path.
        """
        return self.speed_at(self.length)

    def speed_at_pin(self):
        """The speed at C, straight up. :class:`~newton_euler.dynamics.energy.EnergyError` if the
        ball does not get there.
        """
        return self.speed_at(self.pin)


def attraction_field(K, M, m):
    """The force of a mass M at the origin on m at (x, y, z) (11.10), by (11.22), (11.23): a
    function of x, y, z; N if in SI.

    Its potential is :func:`newton_euler.dynamics.potential.gravitational_potential` (11.24);
    :func:`newton_euler.dynamics.potential.find_potential` finds it. Neither exists at the origin.

    >>> attraction_field(1.0, 125.0, 2.0)(3.0, 4.0, 0)
    (-6.0, -8.0, 0)
    """

    def force(x, y, z):
        x, y, z = map(scalar, (x, y, z))
        square = x * x + y * y + z * z
        strength = -(scalar(K) * M * m) / (square * sqrt(square))
        return plain(strength * x), plain(strength * y), plain(strength * z)

    return force


def speed_at_distance(r, r0, v0, K, M):
    """The speed at the distance ``r`` from a mass M, from the speed ``v0`` at ``r0``, on any path
    (11.10): v^2 = v0^2 + 2 K M (1/r - 1/r0).

    m/s if in SI; without cancellation as r -> r0. Raises
    :class:`~newton_euler.dynamics.energy.EnergyError` if the particle does not get so far.

    >>> round(speed_at_distance(4.0, 2.0, 3.0, 1.0, 14.0), 12)
    1.414213562373
    """
    return speed_after(v0, scalar(K) * M * (scalar(r0) - r) / (scalar(r) * r0), 1)


def escape_speed(r, K, M):
    """The least speed at ``r`` with which a particle leaves the mass M for ever (11.10): sqrt(2 K
    M/r), m/s if in SI.

    >>> round(escape_speed(6.371e6, 6.673e-11, 5.97e24))
    11183
    """
    return plain(sqrt(2 * scalar(K) * M / r))
