"""Motion on the turning Earth, 6/18 to 6/23: i east, j north, k up; proofs from the stars."""

from collections.abc import Callable, Sequence

from exercises.annotations import AnyAxes, Givens, Matrix, Number, Scalar
from exercises.tools import Sketch, minus, mp, mpf, plus, rate, rot, scaled, times, transposed
from newton_euler import Frame, Vector, cos, sin
from newton_euler.applications import earth_frame, earth_rate, ground_frame, projectile_position

# m, of the Earth in proofs, which to first order in its rate do not depend on it
RADIUS = mpf(6_400_000)


def ground_axes(g: Givens) -> Frame:
    """The ground at the latitude of g, on the turning Earth."""
    return ground_frame(earth_frame(Frame("stars"), g.omega_e), g.lat)


def shot(g: Givens, t: Scalar, launch: Vector, omega: Vector | None = None) -> Vector:
    """Position of a shot at time t, with named terms; ``omega`` is the Earth's by default."""
    ground = launch.frame
    return projectile_position(t, launch, -g.g * ground.k, omega or earth_rate(ground))


# -- proofs


def axes_turned(g: Givens, angle: Number) -> Matrix:
    """The ground axes as columns, along the initial ones, after the Earth has turned."""
    return rot([0, mp.cos(g.lat), mp.sin(g.lat)], angle)


def flight(
    g: Givens, velocity: Sequence[Number], height: Number = 0
) -> Callable[[Number, Number], list[Number]]:
    """Position relative to the ground, as a function of time and of a share of the Earth's rate, of
    a body that leaves ``height`` with a velocity relative to the ground. In the inertial frame it
    also has the velocity of the ground, and falls along the turning vertical.
    """
    start, up = [0, 0, RADIUS + height], [0, 0, mpf(1)]

    def place(t, share):
        turning = share * g.omega_e
        carried = [turning * mp.cos(g.lat) * start[2], 0, 0]
        # a double integral over time weights the fraction u of the flight by 1 - u: Simpson's rule,
        # accurate to second order in the rate
        ups = plus(up, scaled(2, times(axes_turned(g, turning * t / 2), up)))
        fall = scaled(-g.g * t**2 / 6, ups)
        from_centre = plus(start, scaled(t, plus(velocity, carried)), fall)
        seen = times(transposed(axes_turned(g, turning * t)), from_centre)
        return minus(seen, [0, 0, RADIUS])

    return place


def to_first_order(f: Callable[[Number], list[Number]]) -> list[Number]:
    """The vector f(share of the Earth's rate), to first order in the share, at the full rate."""
    return plus(f(mpf(0)), rate(f))


# -- figures


def globe(g: Givens, ax: AnyAxes) -> tuple[Sketch, Frame]:
    """The Earth with its axis, and the ground axes at the latitude of g."""
    stars = Frame("stars")
    ground = ground_frame(earth_frame(stars, 1), g.lat, radius=1)
    s = Sketch(ax, stars, up="y", azimuth=30, elevation=20)
    O, P = (0, 0, 0), ground.origin
    toward_eye = (cos(0.35) * sin(0.52), sin(0.35), cos(0.35) * cos(0.52))
    for normal in (stars.j, stars.i, toward_eye):
        s.ring(O, normal, 1)
    s.line((0, -1.2, 0), (0, 1.5, 0), style="centre")
    s.turn((0, 1.35, 0), stars.j, label=r"$\omega_e$")
    s.line(O, (0, 0, 1))
    s.line(O, P)
    s.arc(O, (0, 0, 1), P, label=r"$\lambda$")
    s.axes(P, ground, length=0.55, labels=["i", "j", "k"])
    return s, ground


def from_above(ground: Frame, ax: AnyAxes) -> Sketch:
    """A sketch of the ground, with the axes i and j at its corner."""
    s = Sketch(ax, ground, plane="xy")
    s.axes((-2, -1.6, 0), ground, length=0.8, labels=["i, east", "j, north", ""])
    return s
