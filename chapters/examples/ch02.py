"""Worked examples of chapter 2, motion in a plane: a jet of water, a car in a curve, a telescoping
boom, two cars.
"""

from dataclasses import dataclass

from newton_euler import Frame, cos, moving, polar, sin, sqrt, tan
from newton_euler.algebra.scalars import SingularError, is_numeric, size, where
from newton_euler.kinematics.paths import along, frenet


@dataclass(frozen=True)
class Nozzle:
    """Water from a nozzle: the parabola of free fall (2.2) and its curvature (2.4).

    The jet leaves the origin with ``speed`` at ``elevation`` (rad, above the horizontal x axis); y
    is up. Any consistent units.
    Neglected: air resistance, the variation of g, the rotation of the Earth.

    >>> jet = Nozzle(speed=25.0, elevation=0.6108652382, g=32.2)  # ft, s
    >>> round(jet.radius(0.0), 2), round(jet.radius(jet.time_to_top), 2)
    (23.7, 13.02)
    """

    speed: object
    elevation: object
    g: object

    def path(self, t):
        """(x, y, 0) at the time t after leaving the nozzle."""
        return (
            self.speed * t * cos(self.elevation),
            self.speed * t * sin(self.elevation) - self.g * t * t / 2,
            0,
        )

    def water(self, ground, t):
        """The particle of water at the time t, as a moving Point of ``ground``."""
        return ground.point("water", *along(self.path, t))

    time_to_top = property(
        lambda self: self.speed * sin(self.elevation) / self.g, doc="t_h, when y is greatest"
    )
    height = property(
        lambda self: (self.speed * sin(self.elevation)) ** 2 / (2 * self.g), doc="h, the greatest y"
    )
    time_of_flight = property(lambda self: 2 * self.time_to_top, doc="t_R, when y is 0 again")
    range = property(
        lambda self: self.speed**2 * sin(2 * self.elevation) / self.g,
        doc="R, the x at which y is 0 again",
    )

    def height_at(self, x):
        """y of the path at the distance x: a parabola."""
        slope = tan(self.elevation)
        return x * slope - self.g * x * x / (2 * self.speed**2) * (1 + slope * slope)

    def intrinsic(self, t, ground=None):
        """Speed, its rate, curvature and unit vectors at the time t: a
        :class:`~newton_euler.kinematics.paths.Frenet`.
        """
        ground = ground or Frame("ground")
        P = self.water(ground, t)
        return frenet(P.velocity(ground), P.acceleration(ground), name="the jet")

    def radius(self, t):
        """The radius of curvature of the jet at the particle of time t."""
        return self.intrinsic(t).radius


def speed_in_curve(rho, speed_rate, acceleration):
    """The speed in a curve of radius ``rho`` at which the magnitude of the total acceleration is
    ``acceleration`` (2.5), from (2.14).

    speed_rate : rate of change of the speed. Any consistent units. Raises
        :class:`~newton_euler.algebra.scalars.SingularError` if ``speed_rate`` alone
    exceeds the total: then no speed exists.

    >>> round(speed_in_curve(rho=250.0, speed_rate=2.0, acceleration=3.0), 2)  # m, s
    23.64
    """
    square = (acceleration - speed_rate) * (acceleration + speed_rate)
    if is_numeric(square) and size(where(square < 0, 1, 0)) > 0:
        raise SingularError(
            f"the total acceleration {acceleration!r} is less than its tangential component "
            f"{speed_rate!r}: no speed gives that"
        )
    return sqrt(sqrt(rho**2 * square))


def acceleration_in_curve(ground, rho, speed, speed_rate):
    """The acceleration of a car that heads along i of ``ground`` in a curve of radius ``rho`` to
    its left (2.5), by (2.14): a Vector of ``ground``.

    Any consistent units.

    >>> acceleration_in_curve(Frame("ground"), 200.0, 20.0, -4.0)
    Vector(-4.0, 2.0, 0 in ground)
    """
    return ground.vector(speed_rate, speed**2 / rho, 0)


@dataclass(frozen=True)
class TelescopingBoom:
    """The telescoping boom AB of a parked truck, in polar components (2.7) and in a moving frame
    (2.11).

    It turns in the vertical plane about A, the origin; x is horizontal, y up.
    length, elevation : of AB; the elevation in rad above x; numbers or moving. Any consistent
        units.

    >>> ground = Frame("ground")
    >>> boom = TelescopingBoom(moving(20.0, rate=0.5), moving(0.5235987756, rate=-0.075))
    >>> print(boom.end(ground).velocity(ground))
    [0.5, -1.5, 0] in polar axes of B
    """

    length: object
    elevation: object

    def end(self, ground):
        """B as a Point of ``ground`` by its polar coordinates: (2.17), (2.18)."""
        return polar(ground, "B", self.length, self.elevation)

    def end_in_boom_frame(self, ground):
        """B as a Point of a frame fixed in the boom, with i along it: (2.24), (2.25)."""
        boom = ground.rotate("boom", "z", moving(self.elevation))
        return boom.point("B", self.length, 0, 0)


@dataclass(frozen=True)
class TwoCars:
    """One car seen from another that turns (2.12).

    Car A is on a straight road along I. Car B is at the crossing, heading along J in a curve to its
    left: the centre is on the side of -I.
    distance : of A before the crossing; radius : of B's curve; v, rate : speeds and their rates of
        change. Any consistent units.

    >>> cars = TwoCars(distance=30.0, radius=200.0, v_A=25.0, rate_A=2.0, v_B=20.0, rate_B=-4.0)
    >>> print(*cars.A_seen_from_B())
    [25, -17, 0] in car B [0.3, -1.6, 0] in car B
    """

    distance: object
    radius: object
    v_A: object
    rate_A: object
    v_B: object
    rate_B: object

    def scene(self):
        """(ground, B, A): the ground, the frame that turns with car B (at this instant parallel to
        the ground), and car A as a Point.
        """
        ground = Frame("ground")
        at_crossing = ground.point(
            "B",
            moving(0, 0, -self.v_B * self.v_B / self.radius),
            moving(0, self.v_B, self.rate_B),
            0,
        )
        B = ground.rotate(
            "car B",
            "z",
            moving(0, self.v_B / self.radius, self.rate_B / self.radius),
            origin=at_crossing,
        )
        return ground, B, ground.point("A", moving(-self.distance, self.v_A, self.rate_A), 0, 0)

    def A_seen_from_B(self):
        """Velocity and acceleration of A for an observer in B, along B's axes: v_r and a_r of
        (2.24), (2.25).
        """
        _, B, A = self.scene()
        return A.velocity(B).expressed_in(B), A.acceleration(B).expressed_in(B)
