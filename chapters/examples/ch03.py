"""Worked examples of chapter 3, motion in space: a space curve, a coil spring, a cable, a
screw-jack, one vector in three systems.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from newton_euler import Frame, Point, Vector, at, cos, cylindrical, exp, pi, sin, sqrt
from newton_euler.algebra.scalars import Scalar
from newton_euler.kinematics.coordinates import T_phi, T_theta
from newton_euler.kinematics.paths import Frenet, along, at_speed, frenet_along
from newton_euler.kinematics.rotations import apply


def exponential_curve(q: Scalar) -> tuple[Scalar, ...]:
    """(x, y, z) = (e^q, sin q, q^2) at the parameter q (3.1). No units.

    >>> exponential_curve(0.0)
    (1.0, 0.0, 0.0)
    """
    return exp(q), sin(q), q * q


def point_on_exponential_curve(
    ground: Frame, q: Scalar, speed: Scalar, speed_rate: Scalar = 0
) -> Point:
    """The point that passes q on :func:`exponential_curve` with this speed, towards larger q (3.1):
    a moving Point of ``ground``.

    speed, speed_rate : in units of x, y, z per unit of time, and that per unit of time

    >>> ground = Frame("ground")
    >>> print(point_on_exponential_curve(ground, 0.0, 2.0).velocity(ground))
    [1.41421, 1.41421, 0] in ground
    """
    moving_q = at_speed(exponential_curve, q, speed, speed_rate)
    return ground.point("P", *along(exponential_curve, moving_q))


@dataclass(frozen=True)
class Spring:
    """The wire of a coil spring (3.2): a right-handed helix of ``radius`` about z that rises by
    ``rise`` per radian (the pitch over 2 pi). Any consistent units.

    >>> spring = Spring(radius=3.0, rise=4.0)
    >>> spring.flexure, spring.torsion
    (0.12, -0.16)
    """

    radius: Scalar
    rise: Scalar

    def path(self, theta: Scalar) -> tuple[Scalar, ...]:
        """(x, y, z) at the azimuth theta (rad)."""
        return self.radius * cos(theta), self.radius * sin(theta), self.rise * theta

    @property
    def wire(self) -> Scalar:
        """Length of wire per radian."""
        return sqrt(self.radius**2 + self.rise**2)

    @property
    def flexure(self) -> Scalar:
        """f, constant along the wire."""
        return self.radius / (self.radius**2 + self.rise**2)

    @property
    def torsion(self) -> Scalar:
        """tau with the book's sign: negative for a right-handed helix."""
        return -self.rise / (self.radius**2 + self.rise**2)

    def intrinsic(self, theta: Scalar, ground: Frame | None = None) -> Frenet:
        """The Frenet triad and components at the azimuth theta (rad, a number or moving) of a point
        that rises at 1 rad/s.
        """
        return frenet_along(self.path, theta, ground or Frame("ground"), name="the wire")

    @staticmethod
    def drawn_out(wire: Scalar, slope: Scalar) -> "Spring":
        """The spring with the length ``wire`` per radian whose wire rises at the angle ``slope``
        (rad): 0 is flat, a right angle is straight. As it is drawn straight, f tends to 0 and the
        torsion to -1/wire, which is finite (the book says infinite); the straight wire has no e_n
        and so no torsion.

        >>> round(Spring.drawn_out(5.0, 1.57).torsion, 6)
        -0.2
        """
        return Spring(wire * cos(slope), wire * sin(slope))


def cable_residuals(
    tension: Scalar, tension_rate: Scalar, flexure: Scalar, load: Sequence[Scalar]
) -> tuple[Scalar, ...]:
    """The three sums that vanish for a cable at rest in a horizontal plane (3.3): (dT/ds + R1, T f
    + R2, R3), force per length.

    tension, tension_rate : T and dT/ds
    flexure : f of the cable
    load : (R1, R2, R3), the force per length on the cable along e_t, e_n, e_b

    >>> cable_residuals(100.0, -2.0, 0.5, (2.0, -50.0, 0.0))
    (0.0, 0.0, 0.0)
    """
    R1, R2, R3 = load
    return tension_rate + R1, tension * flexure + R2, R3


def cable_load(path: Callable, tension: Callable, q: Scalar, ground: Frame | None = None) -> Vector:
    """The force per length that holds a cable at rest (3.3), a Vector along e_t, e_n, e_b: R1 =
    -dT/ds, R2 = -T f, R3 = 0.

    path, tension : functions of a parameter: (x, y, z) of the cable, and T
    q : the value of the parameter
    Raises :class:`.SingularError` where the cable is straight.

    >>> def post(q):  # a smooth post of radius 2 pushes outwards with T/r
    ...     return 2.0*cos(q), 2.0*sin(q), 0
    >>> print(cable_load(post, lambda q: 100.0, 0.3))
    [0, -50, 0] in e_t, e_n, e_b of the cable
    """
    cable = frenet_along(path, q, ground or Frame("ground"), name="the cable")
    T = at(tension, q)
    return Vector((-T.rate / cable.speed, -T.value * cable.flexure, 0), cable.frame)


def screw_jack_ball(ground: Frame, a: Scalar, K: Scalar, lead: Scalar, t: Scalar) -> Point:
    """The ball on the arm of a screw-jack at the time ``t`` (3.6), a Point of ``ground`` in
    cylindrical coordinates. It starts from rest at theta = 0 and turns about the vertical z axis.

    a, lead : length of the arm; rise in one turn
    K : the constant angular acceleration, rad/s^2

    >>> ground = Frame("ground")
    >>> print(screw_jack_ball(ground, 0.1, 10.0, 0.5, 1.0).velocity(ground))
    [0, 1, 0.795775] in cylindrical axes of ball
    """
    theta = at(lambda time: K * time * time / 2, t)
    return cylindrical(ground, "ball", a, theta, theta * lead / (2 * pi(K)))


def screw_jack_time(turns: Scalar, K: Scalar) -> Scalar:
    """The time (s) of this many turns of the screw-jack from rest (3.6): 2 sqrt(pi turns/K).

    >>> round(screw_jack_time(1, 10.0), 4)
    1.121
    """
    return 2 * sqrt(pi(K) * turns / K)


def three_systems(
    Q: Sequence[Scalar], theta: Scalar, phi: Scalar
) -> tuple[tuple[Scalar, ...], ...]:
    """The rectangular, cylindrical and spherical components of a vector (3.8, 3.9 example 2), from
    its rectangular components ``Q``, in any unit.

    theta, phi : azimuth and elevation in rad; the spherical components are in the order R, theta,
        phi (3.32), (3.38)

    >>> three_systems((5.0, 0, 0), 0.0, 0.0)
    ((5.0, 0, 0), (5.0, -0.0, 0.0), (5.0, 0.0, 0.0))
    """
    cylindrical_components = apply(T_theta(theta), Q)
    return tuple(Q), cylindrical_components, apply(T_phi(phi), cylindrical_components)
