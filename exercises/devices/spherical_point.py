"""A point in spherical coordinates (3/15, 3/16; a proof for others); phi is the elevation."""

from exercises.annotations import AnyAxes, Coordinate, Givens, Number, Path
from exercises.tools import at_angle, elevation, mp, on_ground, second_rate, spherical_axes, times
from newton_euler import cos, kinematics, sin


def place_in_time(R: Coordinate, theta: Coordinate, phi: Coordinate) -> Path:
    """Proof: position over time from coordinates over time."""
    across = lambda t: R(t) * mp.cos(phi(t))
    up = lambda t: R(t) * mp.sin(phi(t))
    return lambda t: at_angle(across(t), theta(t), up(t))


def local_acceleration(A: Path, t: Number = 0) -> list[Number]:
    """Proof: acceleration of A, a position over time, along e_R, e_theta, e_phi."""
    return times(spherical_axes(A(t)), second_rate(A, t))


def elevation_in_time(A: Path) -> Coordinate:
    """Proof: elevation of A, a position over time."""
    return lambda t: elevation(A(t))


def figure(g: Givens, ax: AnyAxes, distance: str = "", theta: float = 0.9) -> None:
    """The figure, with the elevation of g and ``distance``, a label for OP; any azimuth will do."""
    ground, s = on_ground(ax, azimuth=40, elevation=20)
    axes = kinematics.spherical_frame(ground, theta, g.phi)
    c = cos(g.phi)
    O, P = (0, 0, 0), tuple(axes.i.components(ground))
    Q = (c * cos(theta), c * sin(theta), 0)
    s.axes(O, ground, length=0.9)
    s.line(O, P, style="solid")
    s.line(O, Q)
    s.line(Q, P)
    s.arc(O, (1, 0, 0), Q, label=r"$\theta$")
    s.arc(O, Q, P, label=r"$\phi$")
    if distance:
        s.label([0.6 * x for x in P], f"${distance}$", offset=axes.k, bold=False)
    s.axes(P, axes, length=0.35, labels=["$e_R$", r"$e_\theta$", r"$e_\phi$"])
    s.label(O, "O")
    s.dot(P, "P")
    s.label(Q, "Q", offset=(8, -10))
