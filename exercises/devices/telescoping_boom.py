"""The telescoping boom OA of 3/17 and 3/18, on a turning vertical shaft."""

from exercises.annotations import AnyAxes, Coordinate, Number, Path, Scalar
from exercises.tools import Sketch, mp, rot, times
from newton_euler import Frame, moving, pi, spherical
from newton_euler.algebra import Moving
from newton_euler.kinematics.coordinates import CoordinatePoint


def boom_end(omega: Scalar, beta: Moving, length: Scalar) -> tuple[Frame, CoordinatePoint]:
    """Ground, and the end A, for moving ``beta``, from the upward vertical, and ``length``."""
    ground = Frame("ground")
    elevation = pi(beta.value) / 2 - beta
    return ground, spherical(ground, "A", length, moving(0, rate=omega), elevation)


def end_in_time(omega: Number, beta: Coordinate, length: Coordinate) -> Path:
    """Proof: position of A over time, from functions ``beta`` and ``length`` of time."""
    along = lambda t: [length(t) * mp.sin(beta(t)), 0, length(t) * mp.cos(beta(t))]
    return lambda t: times(rot("z", omega * t), along(t))


def figure(ax: AnyAxes, ground: Frame, A: CoordinatePoint) -> Sketch:
    """The figure of this point; returns the sketch."""
    O, l, axes = ground.point("O", 0, 0, 0), A.coordinates[0].value, A.local
    end, sleeve = A.position(ground), axes.i * 0.6
    up, foot = (0, 0, 0.75 * l), (0, 0, -0.5 * l)
    s = Sketch(ax, ground, azimuth=-105, elevation=12)
    s.ground(foot, normal=ground.k, size=0.5 * l)
    s.shaft(foot, O)
    s.rod(O, end)
    s.cylinder(O, [l * x for x in sleeve.components(ground)], 0.045 * l)
    s.hinge(O, axes.j)
    s.line(O, up)
    s.turn((0, 0, -0.3 * l), ground.k, label=r"$\omega$")
    s.arc(O, up, end, label=r"$\beta$")
    s.swing(O, A, axes.j, label=r"$\dot\beta$")
    s.label(end * 0.5 - axes.k * (0.13 * l), "$l$", offset=(0, 0), bold=False)
    s.label(O, "O", offset=(-12, -4))
    s.dot(end, "A")
    return s
