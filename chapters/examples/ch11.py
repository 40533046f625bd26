"""Worked examples of chapter 11, work and energy: a pendulum that meets a pin (11.8, 11.12),
gravitational attraction (11.10), a rolling sphere (11.15), a top (11.16), a physical pendulum
(11.17), a car on a hill (11.19).

``k`` of a round body is its moment of inertia about the centre over m R^2: 2/5 for a solid sphere
(the default), 2/3 for a shell, 1/2 for a cylinder.
"""

from collections.abc import Callable
from dataclasses import dataclass

from newton_euler import Model, cos, pi, sin, sqrt, tan
from newton_euler.algebra.ledger import Amount, summed
from newton_euler.algebra.portable import Formula
from newton_euler.algebra.scalars import Scalar, scalar, to_plain
from newton_euler.dynamics.energy import gyroscope_energy, plane_kinetic_energy, speed_after
from newton_euler.dynamics.potential import weight_potential
from newton_euler.dynamics.work import work_integral
from newton_euler.scenes.planar.rolling_sphere import inertia_ratio


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
        right = pi(self.angle) / 2 + zero
        down = work_integral(lambda a: self.g * sin(a) * self.length, zero, self.angle, exact=exact)
        rising = work_integral(lambda a: -(self.g * sin(a)) * rest, 0, right, exact=exact)
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
        """The speed at C, straight up. Raises :class:`.EnergyError` if it does not reach C."""
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
        return to_plain(strength * x), to_plain(strength * y), to_plain(strength * z)

    return force


def speed_at_distance(r: Scalar, r0: Scalar, v0: Scalar, K: Scalar, M: Scalar) -> Scalar:
    """The speed at the distance ``r`` from a mass M, from the speed ``v0`` at ``r0``, on any path
    (11.10): v^2 = v0^2 + 2 K M (1/r - 1/r0), without cancellation as r -> r0; m/s if in SI. Raises
    :class:`.EnergyError` if the particle does not reach it.

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
    return to_plain(sqrt(2 * scalar(K) * M / r))


def rolling_energy(
    m: Scalar, R: Scalar, speed: Scalar, pivoting: Scalar = 0, k: Scalar | None = None
) -> Amount:
    """T of the rolling body with terms ``translation``, ``rolling`` and ``pivoting`` (11.45): 7/10
    m v^2 for a sphere that does not pivot.

    pivoting : the component of omega along the normal of the plane, rad/s, which the book takes to
        be zero. Rolling does not change it: for a sphere it only adds a constant.

    >>> round(rolling_energy(2.0, 0.5, 3.0).value, 9)
    12.6
    """
    k, translation = inertia_ratio(m, k), scalar(m) * speed * speed / 2
    spun = k * (scalar(m) * R * R) * (scalar(pivoting) * pivoting) / 2
    terms = {"translation": translation, "rolling": k * translation, "pivoting": spun}
    return summed(terms, "kinetic energy", "11.45")


def rolling_speed(drop: Scalar, g: Scalar, v0: Scalar = 0, k: Scalar | None = None) -> Scalar:
    """The speed of the centre after a descent by ``drop``: sqrt(v0^2 + 2 g h/(1 + k)), from rest
    sqrt(10 g h/7) for a sphere (11.49). The contact is at rest, so its force does no work; without
    rolling it would be sqrt(2 g h), on any incline.

    >>> round(rolling_speed(0.7, 10.0), 9)
    3.16227766
    """
    return speed_after(v0, scalar(g) * drop, 1 + inertia_ratio(g, k))


def friction_needed(slope: Scalar, k: Scalar | None = None) -> Scalar:
    """Friction over normal force of the rolling body: k tan(slope)/(1 + k); with less, it slips.

    >>> round(friction_needed(0.7853981633974483), 6)
    0.285714
    """
    k = inertia_ratio(slope, k)
    return to_plain(k * tan(slope) / (1 + k))


def top_energy(
    I0: Scalar,
    I: Scalar,
    mgr: Scalar,
    theta: Scalar,
    theta_rate: Scalar,
    precession: Scalar,
    spin: Scalar,
) -> Amount:
    """T + V of a top about its fixed point, an Amount with the terms ``transverse``, ``axial`` and
    ``weight``; constant during the motion. Arguments as in
    :mod:`newton_euler.applications.gyroscopes`. V = + mgr cos(theta), since theta is counted from
    the *upward* vertical and the moment of the weight, + mgr sin(theta) (10.30), makes it grow. The
    book prints a minus sign here, with which the sum is not constant.

    >>> top_energy(1.5, 1.0, 10.0, 0.0, 0.0, 2.0, 3.0).terms
    {'transverse': 0.0, 'axial': 12.5, 'weight': 10.0}
    """
    T = gyroscope_energy(I0, I, theta, theta_rate, precession, spin)
    return summed({**T.terms, "weight": scalar(mgr) * cos(theta)}, "energy", "11.32")


def pendulum_energy(
    m: Scalar, I: Scalar, l: Scalar, g: Scalar, theta: Scalar, omega: Scalar
) -> Amount:
    """T + V = (I + m l^2) omega^2/2 - m g l cos(theta), with the terms ``translation``,
    ``rotation`` (11.51) and ``weight``, zero at the axis.

    >>> pendulum_energy(2.0, 0.5, 0.5, 10.0, 0.0, 3.0).terms
    {'translation': 2.25, 'rotation': 2.25, 'weight': -10.0}
    """
    T = plane_kinetic_energy(m, scalar(l) * omega, I, omega)
    weight = weight_potential(m, -(scalar(l) * cos(theta)), g)
    return summed({**T.terms, "weight": weight}, "energy", "11.32")


def swing_rate(
    m: Scalar, I: Scalar, l: Scalar, g: Scalar, theta: Scalar, theta0: Scalar, omega0: Scalar = 0
) -> Scalar:
    """The absolute value of omega at the angle theta, from that at theta0, without cancellation as
    theta -> theta0; :class:`.EnergyError` if the pendulum does not reach theta.

    >>> round(swing_rate(2.0, 0.5, 0.5, 10.0, 0.0, 1.5707963267948966), 6)
    4.472136
    """
    # cos(theta) - cos(theta0)
    drop = 2 * sin((scalar(theta0) + theta) / 2) * sin((scalar(theta0) - theta) / 2)
    return speed_after(omega0, scalar(m) * g * l * drop, I + scalar(m) * l * l)


@dataclass(frozen=True)
class Car:
    """A car on wheels that roll without slipping.

    m : mass of the whole car, wheels included; wheel_mass, gyration, radius : of each wheel, its
        radius of gyration about the axle and its radius
    drag : the resistance on the level, of the air and the wheels, as a function of the speed; g :
        gravity

    >>> drag = lambda v: 0.5*v*v
    >>> car = Car(m=1200.0, wheel_mass=20.0, gyration=0.25, radius=0.3, drag=drag, g=9.81)
    >>> round(car.power(20.0, 1.0, 0.0), 1)
    29111.1
    """

    m: Scalar
    wheel_mass: Scalar
    gyration: Scalar
    radius: Scalar
    drag: Callable[[Scalar], Scalar]
    g: Scalar
    wheels: int = 4

    def kinetic_energy(self, v: Scalar) -> Amount:
        """T at the speed v, an Amount with the terms ``translation`` and ``wheels`` (11.45),
        (11.48).
        """
        terms = {"translation": scalar(self.m) * v * v / 2, "wheels": self._wheels() * v * v / 2}
        return summed(terms, "kinetic energy", "11.45")

    def powers(self, v: Scalar, a: Scalar, slope: Scalar) -> Amount:
        """The power at the wheels, an Amount in W with the terms ``accelerate``, ``wheels``,
        ``climb`` and ``air``.

        v, a : speed and acceleration; slope : inclination of the road, rad, positive uphill. It is
            the rate of (11.48).
        """
        terms = {
            "accelerate": scalar(self.m) * v * a,
            "wheels": self._wheels() * v * a,
            "climb": scalar(self.m) * self.g * v * sin(slope),
            "air": scalar(self.drag(v)) * v,
        }
        return summed(terms, "power", "rate of 11.48")

    def power(self, v: Scalar, a: Scalar, slope: Scalar) -> Scalar:
        """The power at the wheels, W: the sum of :meth:`powers`."""
        return self.powers(v, a, slope).value

    def acceleration(self, power: Scalar, v: Scalar, slope: Scalar) -> Scalar:
        """The acceleration at the speed v (not zero) that this power gives: :meth:`powers` solved
        for a.
        """
        left = scalar(power) - scalar(self.m) * self.g * v * sin(slope) - scalar(self.drag(v)) * v
        return to_plain(left / ((self.m + self._wheels()) * v))

    def model(self, power: Scalar | Formula, slope: Scalar | Formula) -> Model:
        """The motion up a hill as a Model with the states s, the distance, and v; ``power`` and
        ``slope`` numbers or laws (s, p, t).
        """

        def rates(s, p, t):
            return s.v, self.acceleration(p.power, s.v, p.slope)

        return Model("car on a hill", {"power": power, "slope": slope}, ("s", "v"), rates)

    def _wheels(self):
        """The moments of inertia of the wheels over radius^2, which act as an added mass."""
        ratio = scalar(self.gyration) / self.radius
        return self.wheels * self.wheel_mass * (ratio * ratio)
