"""The helix of 3/4, 3/5 and 3/7, about the z axis; its rise is per radian."""

from collections.abc import Callable

from exercises.annotations import AnyAxes, Number, Path, Scalar, Triple
from exercises.tools import Sketch, at_angle, mp
from newton_euler import Frame, cos, cylindrical, pi, sin
from newton_euler.kinematics.coordinates import CoordinatePoint


def helix(radius: Scalar, rise: Scalar) -> Callable[[Scalar], Triple]:
    """The helix as a function of the angle about z."""
    return lambda theta: (radius * cos(theta), radius * sin(theta), rise * theta)


def on_helix(radius: Scalar, rise: Scalar, theta: Scalar) -> CoordinatePoint:
    """P on the helix in cylindrical coordinates, in its own ground; ``theta`` may be ``moving``."""
    return cylindrical(Frame("ground"), "P", radius, theta, rise * theta)


def unrolled(radius: Number, rise: Number, speed: Number, start: Number = 0) -> Path:
    """Proof: position at constant speed; unrolled, the helix is a hypotenuse above its circle."""
    turn = 2 * mp.pi * radius
    along = mp.hypot(turn, 2 * mp.pi * rise)
    theta = lambda t: start + 2 * mp.pi * speed * t / along
    return lambda t: at_angle(radius, theta(t), rise * theta(t))


def figure(
    ax: AnyAxes,
    ground: Frame,
    radius: Scalar,
    rise: Scalar,
    theta: Scalar,
    name: str,
    turns: float = 1.25,
) -> tuple[Sketch, Triple, Triple, Triple]:
    """The helix on its cylinder, and P at ``theta``: (sketch, foot of the axis, foot of P, P)."""
    s = Sketch(ax, ground, azimuth=35, elevation=22)
    high = 2 * pi() * rise * turns
    for z in (0, high):
        s.ring((0, 0, z), ground.k, radius)
    s.line((0, 0, 0), (0, 0, 1.1 * high), style="centre")
    last = 2 * pi() * turns
    s.path([helix(radius, rise)(last * n / 120) for n in range(121)])
    P = helix(radius, rise)(theta)
    s.axes((0, 0, 0), ground, length=1.6 * radius, labels=["x", "y", ""])
    s.dimension((0, 0, high), (0, radius, high), label=name)
    s.dot(P, "P")
    return s, (0, 0, 0), (P[0], P[1], 0), P
