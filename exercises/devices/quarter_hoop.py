"""A collar on a smooth quarter hoop (11/4, 11/5): O the origin, y up; A left, B below."""

from exercises.annotations import AnyAxes, Givens, Number, Scalar
from exercises.catalogue.proofs.digits import Force
from exercises.tools import Sketch, mp, plus, until
from newton_euler import Frame, Point, pi
from newton_euler.dynamics import constant_force_work, weight


def hoop(g: Givens) -> tuple[Frame, Point, Point, Point]:
    """The ground, O, and the ends A and B."""
    ground = Frame("ground")
    A, B = ground.point("A", -g.R, 0, 0), ground.point("B", 0, -g.R, 0)
    return ground, ground.origin, A, B


def work_of_weight(g: Givens) -> Scalar:
    ground, _, A, B = hoop(g)
    return constant_force_work(weight(g.m, ground.j, g.g), A, B).value


def slides(g: Givens, pull: Force = lambda place: [0, 0]) -> tuple[Number, Number]:
    """Proof: (time, speed at B) after release at A; ``pull(place)`` is a further force."""

    def rates(state):
        angle, u = state
        along = [mp.sin(angle), -mp.cos(angle)]
        F = plus(pull([-g.R * mp.cos(angle), -g.R * mp.sin(angle)]), [0, -g.m * g.g])
        return [u, sum(f * e for f, e in zip(F, along, strict=True)) / (g.m * g.R)]

    step = mp.sqrt(g.R / g.g) / 8
    t, (_, u) = until(rates, [0 * step, 0 * step], lambda s: s[0] - mp.pi / 2, step)
    return t, u * g.R


def sketch(g: Givens, ax: AnyAxes) -> tuple[Sketch, tuple[Frame, Point, Point, Point]]:
    """The ground, the hoop with the collar at A, and R; returns the sketch and the points."""
    ground, O, A, B = points = hoop(g)
    s = Sketch(ax, ground, plane="xy")
    half = 0.05 * g.R
    s.wire(s.around(O, A, ground.k, pi(1.0) / 2))
    s.box(A, ground, (3 * half, 4 * half, 2 * half))
    s.line(O, B)
    s.label(A, "A", offset=(-22, 8))
    s.label(A, "m", offset=(-22, -10), bold=False)
    s.dot(B, "B", offset=(-2, -14))
    s.label(O, "O", offset=(8, 10))
    return s, points
