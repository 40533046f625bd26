"""The nozzle of 4/2 (and 3/14), turning about the vertical through O, with outward flow."""

from exercises.annotations import AnyAxes, Givens, Path
from exercises.tools import Sketch, mp, rot, times
from newton_euler import Frame, Point, moving


def nozzle_and_particle(g: Givens) -> tuple[Frame, Frame, Point]:
    """Ground with Z up; a frame turning with the nozzle, x outward; the particle, z along it."""
    ground = Frame("ground")
    turning = ground.rotate("turning", "z", rate=g.omega)
    nozzle = turning.rotate("nozzle", "y", angle=g.tilt)
    return ground, turning, nozzle.point("P", 0, 0, moving(g.d, rate=g.nu))


def particle_in_time(g: Givens) -> Path:
    """Proof: position of the particle over time."""
    d = lambda t: g.d + g.nu * t
    return lambda t: times(rot("z", g.omega * t), [d(t) * mp.sin(g.tilt), 0, d(t) * mp.cos(g.tilt)])


def figure(g: Givens, ax: AnyAxes, ground: Frame, turning: Frame, P: Point) -> Sketch:
    """The figure without axes; returns the sketch."""
    nozzle, O = P.frame, (0, 0, 0)
    up = ground.point("up", 0, 0, 1.3 * g.d)
    s = Sketch(ax, ground, azimuth=-105, elevation=15)
    s.line((0, 0, -0.4 * g.d), up, style="centre")
    s.cylinder(O, nozzle.point("end", 0, 0, 1.3 * g.d), 0.035 * g.d)
    s.vector(P, nozzle.k, r"$\nu$")
    s.turn((0, 0, 1.1 * g.d), ground.k, label=r"$\omega$")
    s.arc(O, up, P, label=r"$\gamma$", radius=0.65 * g.d)
    s.dimension(O, P, label="d")
    s.dot(P)
    s.label(O, "O")
    return s
