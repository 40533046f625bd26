"""The screw-jack of 4/1 (and 3/12), which rises by one lead per turn; A ends its handle."""

from exercises.annotations import AnyAxes, Givens, Path, Scalar
from exercises.tools import Sketch, at_angle, mp
from newton_euler import Frame, Point, cos, moving, pi, sin


def rise(g: Givens) -> Scalar:
    """Axial speed of the screw."""
    return g.lead * g.n / (2 * pi(g.n))


def screw_in_nut(g: Givens, rise: Scalar, n: Scalar) -> tuple[Frame, Frame, Point]:
    """Ground with Z up; a frame at B that rises with the screw; A, which turns in it."""
    ground = Frame("ground")
    rising = ground.translate("rising", ground.point("B", 0, 0, moving(0, rate=rise)))
    return ground, rising, rising.rotate("screw", "z", rate=n).point("A", g.a, 0, 0)


def handle_in_time(g: Givens) -> Path:
    """Proof: position of A over time, a circle about the axis and the lead times the turns."""
    return lambda t: at_angle(g.a, g.n * t, g.lead * g.n * t / (2 * mp.pi))


def figure(g: Givens, ax: AnyAxes, ground: Frame, rising: Frame, A: Point) -> Sketch:
    """The figure without axes; returns the sketch."""
    B, thick, low = rising.origin, 0.15 * g.a, -0.3 * g.a - 2.5 * g.lead
    s = Sketch(ax, ground, azimuth=-110, elevation=18)
    s.box((0, 0, low), ground, (0.9 * g.a, 0.7 * g.a, 0.3 * g.a))
    s.cylinder((0, 0, low + 0.15 * g.a), B, thick)
    lowest, right = -0.1 * g.a - 2.4 * g.lead, -20 * pi() / 180  # the visible edge of the screw

    def on_thread(turns):
        w = right + 2 * pi() * turns
        return thick * cos(w), thick * sin(w), lowest + g.lead * turns

    s.path([on_thread(n / 40) for n in range(101)], on=(B, (0, 0, low)))
    s.rod(B, A)
    s.ground((-0.45 * g.a, 0, low - 0.15 * g.a), normal=ground.k)
    s.turn((0, 0, 0.25 * g.a), ground.k, label="n")
    s.dimension(B, A, label="a")
    s.dimension(on_thread(2), on_thread(1), label=r"$\ell$")
    s.label(A, "A")
    return s
