"""Worked examples of chapter 2, motion in a plane: a jet of water, a car in a curve, a telescoping
boom, two cars.
"""

from dataclasses import dataclass

from newton_euler import Frame, Point, Vector, cos, moving, polar, sin, sqrt, tan
from newton_euler.algebra.scalars import Scalar, SingularError, is_numeric, max_abs, where
from newton_euler.kinematics.paths import Frenet, along, frenet


@dataclass(frozen=True)
class Nozzle:
    """Water from a nozzle: the parabola of free fall (2.2) and its curvature (2.4).

    The jet leaves the origin with ``speed`` at ``elevation`` (rad, above the horizontal x axis); y
    is up. Any consistent units. Neglected: air resistance, the variation of g, the rotation of the
    Earth.

    >>> jet = Nozzle(speed=25.0, elevation=0.6108652382, g=32.2)  # ft, s
    >>> round(jet.radius(0.0), 2), round(jet.radius(jet.time_to_top), 2)
    (23.7, 13.02)
    """

    speed: Scalar
    elevation: Scalar
    g: Scalar

    def path(self, t: Scalar) -> tuple[Scalar, ...]:
        """(x, y, 0) at the time t after leaving the nozzle."""
        x, y = self.speed * t * cos(self.elevation), self.speed * t * sin(self.elevation)
        return x, y - self.g * t * t / 2, 0

    def water(self, ground: Frame, t: Scalar) -> Point:
        """The particle of water at the time t, as a moving Point of ``ground``."""
        return ground.point("water", *along(self.path, t))

    @property
    def time_to_top(self) -> Scalar:
        """t_h, the time at which y is greatest."""
        return self.speed * sin(self.elevation) / self.g

    @property
    def height(self) -> Scalar:
        """h, the greatest y."""
        return (self.speed * sin(self.elevation)) ** 2 / (2 * self.g)

    @property
    def time_of_flight(self) -> Scalar:
        """t_R, the time at which y is 0 again."""
        return 2 * self.time_to_top

    @property
    def range(self) -> Scalar:
        """R, the x at which y is 0 again."""
        return self.speed**2 * sin(2 * self.elevation) / self.g

    def height_at(self, x: Scalar) -> Scalar:
        """The height y of the path at the distance x, a parabola."""
        slope = tan(self.elevation)
        return x * slope - self.g * x * x / (2 * self.speed**2) * (1 + slope * slope)

    def intrinsic(self, t: Scalar, ground: Frame | None = None) -> Frenet:
        """Speed, its rate, curvature and unit vectors at the time t."""
        ground = ground or Frame("ground")
        P = self.water(ground, t)
        return frenet(P.velocity(ground), P.acceleration(ground), name="the jet")

    def radius(self, t: Scalar) -> Scalar:
        """The radius of curvature of the jet at the particle of the time t."""
        return self.intrinsic(t).radius


def speed_in_curve(rho: Scalar, speed_rate: Scalar, acceleration: Scalar) -> Scalar:
    """The speed in a curve of radius ``rho`` at which the magnitude of the total acceleration is
    ``acceleration`` (2.5), from (2.14); ``speed_rate`` is the rate of change of the speed. Any
    consistent units. Raises :class:`.SingularError` if ``speed_rate`` alone exceeds the total.

    >>> round(speed_in_curve(rho=250.0, speed_rate=2.0, acceleration=3.0), 2)  # m, s
    23.64
    """
    square = (acceleration - speed_rate) * (acceleration + speed_rate)
    if is_numeric(square) and max_abs(where(square < 0, 1, 0)) > 0:
        raise SingularError(
            f"the total acceleration {acceleration!r} is less than its tangential component "
            f"{speed_rate!r}: no speed gives that; give a larger total or a smaller speed_rate"
        )
    return sqrt(sqrt(rho**2 * square))


def acceleration_in_curve(ground: Frame, rho: Scalar, speed: Scalar, speed_rate: Scalar) -> Vector:
    """The acceleration of a car that moves along i of ``ground`` in a curve of radius ``rho`` to
    its left (2.5), by (2.14): a Vector of ``ground``. Any consistent units.

    >>> acceleration_in_curve(Frame("ground"), 200.0, 20.0, -4.0)
    Vector(-4.0, 2.0, 0 in ground)
    """
    return ground.vector(speed_rate, speed**2 / rho, 0)


@dataclass(frozen=True)
class TelescopingBoom:
    """The telescoping boom AB of a parked truck, in polar components (2.7) and in a moving frame
    (2.11). It turns in the vertical plane about A, the origin; x is horizontal, y up.

    length : of AB; any consistent units
    elevation : of AB above x, in rad; both numbers or moving

    >>> ground = Frame("ground")
    >>> boom = TelescopingBoom(moving(20.0, rate=0.5), moving(0.5235987756, rate=-0.075))
    >>> print(boom.end(ground).velocity(ground))
    [0.5, -1.5, 0] in polar axes of B
    """

    length: Scalar
    elevation: Scalar

    def end(self, ground: Frame) -> Point:
        """B as a Point of ``ground`` by its polar coordinates: (2.17), (2.18)."""
        return polar(ground, "B", self.length, self.elevation)

    def end_in_boom_frame(self, ground: Frame) -> Point:
        """B as a Point of a frame fixed in the boom, with i along it: (2.24), (2.25)."""
        return ground.rotate("boom", "z", moving(self.elevation)).point("B", self.length, 0, 0)


@dataclass(frozen=True)
class TwoCars:
    """One car seen from another that turns (2.12). Car A is on a straight road along I. Car B is at
    the crossing and moves along J in a curve to its left: the centre is on the side of -I. Any
    consistent units.

    distance : of A before the crossing
    radius : of B's curve
    v_A, v_B, rate_A, rate_B : speeds and their rates of change

    >>> cars = TwoCars(distance=30.0, radius=200.0, v_A=25.0, rate_A=2.0, v_B=20.0, rate_B=-4.0)
    >>> print(*cars.A_seen_from_B())
    [25, -17, 0] in car B [0.3, -1.6, 0] in car B
    """

    distance: Scalar
    radius: Scalar
    v_A: Scalar
    rate_A: Scalar
    v_B: Scalar
    rate_B: Scalar

    def scene(self) -> tuple[Frame, Frame, Point]:
        """(ground, B, A): the ground, the frame that turns with car B (at this instant parallel to
        the ground), and car A as a Point.
        """
        ground, v, rate, r = Frame("ground"), self.v_B, self.rate_B, self.radius
        at_crossing = ground.point("B", moving(0, 0, -v * v / r), moving(0, v, rate), 0)
        B = ground.rotate("car B", "z", moving(0, v / r, rate / r), origin=at_crossing)
        return ground, B, ground.point("A", moving(-self.distance, self.v_A, self.rate_A), 0, 0)

    def A_seen_from_B(self) -> tuple[Vector, Vector]:
        """The velocity and the acceleration of A for an observer in B, along B's axes: v_r and a_r
        of (2.24), (2.25).
        """
        _, B, A = self.scene()
        return A.velocity(B).expressed_in(B), A.acceleration(B).expressed_in(B)
