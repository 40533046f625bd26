"""Worked examples of chapter 11, work and energy: a pendulum that meets a pin (11.8, 11.12),
gravitational attraction (11.10).
"""

from collections.abc import Callable
from dataclasses import dataclass

from newton_euler import cos, pi, sin, sqrt
from newton_euler.algebra.ledger import Amount, summed
from newton_euler.algebra.scalars import Scalar, plain, scalar
from newton_euler.dynamics.energy import speed_after
from newton_euler.dynamics.potential import weight_potential
from newton_euler.dynamics.work import work_integral


@dataclass(frozen=True)
class PendulumWithPin:
    """A ball on a cord that meets a pin when it hangs straight down, and then swings about the pin
    on the rest of the cord (11.8, 11.12).

    It is released at A, at ``angle`` from the downward vertical, with the speed ``v0``; C is level
    with the pin. Work and energy are those of a unit mass. The cord does no work: it is normal to
    the path. Any consistent units.

    length : of the cord
    pin : distance of the pin straight below the support
    angle : rad, less than a right angle
    g : gravity

    >>> import math
    >>> ball = PendulumWithPin(length=0.9, pin=0.6, angle=math.radians(60), v0=2.0, g=9.81)
    >>> round(ball.speed_at_bottom(), 3), round(ball.speed_at_pin(), 3)
    (3.582, 2.635)
    """

    length: Scalar
    pin: Scalar
    angle: Scalar
    v0: Scalar
    g: Scalar

    def works(self, exact: bool = False) -> Amount:
        """The work of the weight with its terms on the two arcs, integrals of its tangential
        component over their length (11.3); exact=True: by SymPy.
        """
        rest, zero = scalar(self.length) - self.pin, 0 * self.angle
        down = work_integral(lambda a: self.g * sin(a) * self.length, zero, self.angle, exact=exact)
        rising = work_integral(
            lambda a: -(self.g * sin(a)) * rest, 0, pi(self.angle) / 2 + zero, exact=exact
        )
        terms = {"A to the bottom": down, "bottom to C": rising}
        return summed(terms, number="11.3", error=down.error + rising.error)

    def energy(self, depth: Scalar, speed: Scalar) -> Amount:
        """T + V of a unit mass at this depth below the support (11.30), (11.34): constant during
        the motion.
        """
        potential = weight_potential(1, -scalar(depth), self.g)
        terms = {"kinetic": scalar(speed) * speed / 2, "potential": potential}
        return summed(terms, "energy", "11.30")

    def speed_at(self, depth: Scalar) -> Scalar:
        """The speed at this depth below the support, on either arc: v^2 = v0^2 + 2 g (depth - depth
        of A) (11.4), (11.32).
        """
        return speed_after(self.v0, self.g * (depth - self.length * cos(self.angle)), 1)

    def speed_at_bottom(self) -> Scalar:
        """The speed at the lowest point, where the cord meets the pin; it does not change there,
        since the cord pulls at right angles to the path.
        """
        return self.speed_at(self.length)

    def speed_at_pin(self) -> Scalar:
        """The speed at C, straight up. Raises :class:`~newton_euler.dynamics.energy.EnergyError` if
        the ball does not reach C.
        """
        return self.speed_at(self.pin)


def attraction_field(K: Scalar, M: Scalar, m: Scalar) -> Callable:
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


def speed_at_distance(r: Scalar, r0: Scalar, v0: Scalar, K: Scalar, M: Scalar) -> Scalar:
    """The speed at the distance ``r`` from a mass M, from the speed ``v0`` at ``r0``, on any path
    (11.10): v^2 = v0^2 + 2 K M (1/r - 1/r0).

    m/s if in SI; without cancellation as r -> r0. Raises
    :class:`~newton_euler.dynamics.energy.EnergyError` if the particle does not reach it.

    >>> round(speed_at_distance(4.0, 2.0, 3.0, 1.0, 14.0), 12)
    1.414213562373
    """
    return speed_after(v0, scalar(K) * M * (scalar(r0) - r) / (scalar(r) * r0), 1)


def escape_speed(r: Scalar, K: Scalar, M: Scalar) -> Scalar:
    """The least speed at ``r`` with which a particle escapes from the mass M (11.10): sqrt(2 K
    M/r), m/s if in SI.

    >>> round(escape_speed(6.371e6, 6.673e-11, 5.97e24))
    11183
    """
    return plain(sqrt(2 * scalar(K) * M / r))
