"""The crane of 4/4 (and 3/26), which revolves while its boom OP is lowered."""

from exercises.annotations import AnyAxes, Givens, Path
from exercises.devices.boom import turning_boom
from exercises.tools import Sketch, mp, rot, times
from newton_euler import Frame, Point, moving


def crane(g: Givens) -> tuple[Frame, Frame, Point]:
    """Ground with Z up; the house, turning, x outward in the boom's plane; P on the boom's z."""
    ground, house, boom = turning_boom(g.n, moving(g.beta_1, g.b_dot))
    return ground, house, boom.point("P", 0, 0, g.R)


def tip_in_time(g: Givens) -> Path:
    """Proof: position of P over time."""
    beta = lambda t: g.beta_1 + g.b_dot * t
    return lambda t: times(rot("z", g.n * t), [g.R * mp.sin(beta(t)), 0, g.R * mp.cos(beta(t))])


def figure(g: Givens, ax: AnyAxes, ground: Frame, house: Frame, P: Point) -> Sketch:
    """The figure without axes; returns the sketch."""
    O, up, foot = ground.point("O", 0, 0, 0), (0, 0, 0.6 * g.R), (0, 0, -0.3 * g.R)
    s = Sketch(ax, ground, azimuth=-112, elevation=18)
    s.ground(foot, normal=ground.k, size=0.8 * g.R)
    s.cylinder(foot, (0, 0, -0.22 * g.R), 0.2 * g.R)
    s.box((-0.07 * g.R, 0, -0.11 * g.R), house, (0.34 * g.R, 0.22 * g.R, 0.22 * g.R))
    s.rod(O, P)
    s.hinge(O, house.j)
    s.line(O, up)
    s.arc(O, up, P, label=r"$\beta$")
    s.turn((0, 0, 0.5 * g.R), ground.k, label="n")
    s.swing(O, P, house.j, label=r"$\dot\beta$")
    s.label(P.position(ground) * 0.55, "$R$", offset=ground.i, bold=False)
    s.label(O, "O", offset=(9, -14))
    s.label(P, "P")
    return s
