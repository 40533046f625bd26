"""Water from a nozzle: the parabola of free fall and its curvature (2.2, 2.4)."""

from dataclasses import dataclass

from ..paths import along, frenet
from ..scalars import cos, sin, tan


@dataclass(frozen=True)
class Nozzle:
    """A jet that leaves the origin with ``speed`` at ``elevation`` (rad, above the horizontal x axis) and falls freely; y is up.

    Neglected: air resistance, and that g varies and the Earth turns. Any consistent units.

    >>> jet = Nozzle(speed=25.0, elevation=0.6108652382, g=32.2)
    >>> round(jet.radius(0.0), 2), round(jet.radius(jet.time_to_top), 2)
    (23.7, 13.02)
    """

    speed: object
    elevation: object
    g: object

    def path(self, t):
        """(x, y, 0) at the time t after leaving the nozzle."""
        return self.speed * t * cos(self.elevation), self.speed * t * sin(self.elevation) - self.g * t * t / 2, 0

    def water(self, ground, t):
        """The particle of water at the time t, as a moving Point of ``ground``."""
        return ground.point("water", *along(self.path, t))

    time_to_top = property(lambda self: self.speed * sin(self.elevation) / self.g, doc="t_h, when y is greatest")
    height = property(lambda self: (self.speed * sin(self.elevation)) ** 2 / (2 * self.g), doc="h, the greatest y")
    time_of_flight = property(lambda self: 2 * self.time_to_top, doc="t_R, when y is 0 again")
    range = property(lambda self: self.speed**2 * sin(2 * self.elevation) / self.g, doc="R, the x at which y is 0 again")

    def height_at(self, x):
        """y of the path at the distance x: a parabola."""
        slope = tan(self.elevation)
        return x * slope - self.g * x * x / (2 * self.speed**2) * (1 + slope * slope)

    def intrinsic(self, t, ground=None):
        """Speed, its rate, curvature and unit vectors at the time t: a :class:`~newton_euler.paths.Frenet`."""
        from ..frames import Frame

        ground = ground or Frame("ground")
        P = self.water(ground, t)
        return frenet(P.velocity(ground), P.acceleration(ground), name="the jet")

    def radius(self, t):
        """The radius of curvature of the stream where the particle is at the time t."""
        return self.intrinsic(t).radius
