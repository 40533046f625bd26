"""The robot arm of 4/3, 3/25: perpendicular links OA, AP in a plane that turns with the base."""

from exercises.annotations import AnyAxes, Givens, Path
from exercises.devices.boom import turning_boom
from exercises.tools import Sketch, mp, rot, times
from newton_euler import Frame, Point, moving


def robot(g: Givens) -> tuple[Frame, Frame, Point]:
    """Ground with Z up; the base, x outward; P in their frame: OA along z, AP along x."""
    ground, base, arms = turning_boom(g.omega, moving(g.beta_1, g.b_dot, g.b_ddot))
    return ground, base, arms.point("P", g.l_AP, 0, g.l_OA)


def tip_in_time(g: Givens) -> Path:
    """Proof: position of P over time."""

    def P(t):
        beta = g.beta_1 + g.b_dot * t + g.b_ddot * t**2 / 2
        c, s = mp.cos(beta), mp.sin(beta)
        return times(rot("z", g.omega * t), [g.l_OA * s + g.l_AP * c, 0, g.l_OA * c - g.l_AP * s])

    return P


def figure(g: Givens, ax: AnyAxes, ground: Frame, base: Frame, P: Point) -> Sketch:
    """The figure without axes; returns the sketch."""
    O, A = ground.point("O", 0, 0, 0), P.frame.point("A", 0, 0, g.l_OA)
    up, foot = (0, 0, 0.8 * g.l_OA), (0, 0, -0.5 * g.l_OA)
    x, _, z = A.position(ground)
    level = (x + 0.9 * g.l_AP, 0, z)
    s = Sketch(ax, ground, azimuth=-105, elevation=12)
    s.ground(foot, normal=ground.k)
    s.shaft(foot, O)
    s.rod(O, A, P)
    s.hinge(O, ground.j)
    s.line(O, up)
    s.line(A, level)
    s.arc(O, up, A, label=r"$\beta$")
    s.arc(A, level, P, label=r"$\beta$")
    s.swing(O, P, ground.j, label=r"$\dot\beta,\ \ddot\beta$")
    s.turn((0, 0, -0.25 * g.l_OA), ground.k, label=r"$\omega$")
    s.dimension(O, A, label=r"$l_{OA}$", offset=0.24 * g.l_OA)
    s.dimension(A, P, label=r"$l_{AP}$", offset=-0.12 * g.l_OA)
    for point in (O, A, P):
        s.label(point, point.name)
    return s
