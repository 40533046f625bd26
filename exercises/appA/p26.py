"""A/26: the points of a line, reached from Q by s R."""

from exercises.tools import Sketch, proofs
from newton_euler import Frame


def line(g):
    axes = Frame("axes")
    return axes, axes.point("Q", g.Q_x, g.Q_y, g.Q_z), axes.vector(g.R_x, g.R_y, g.R_z)


def solve(g):
    axes, Q, R = line(g)
    return {"r": Q.position(axes) + g.s * R}


def prove(g):
    """By integration at the rate R per unit of s."""
    Q, R = [g.Q_x, g.Q_y, g.Q_z], [g.R_x, g.R_y, g.R_z]
    return {"r": proofs.plus(Q, proofs.integral(lambda _: R, 0, g.s))}


def mistakes(g):
    axes, Q, R = line(g)
    q = Q.position(axes)
    return {
        "exchanged": {"r": R + g.s * q},
        "unit_vector": {"r": q + g.s * R.direction()},
        "no_point": {"r": g.s * R},
    }


def draw(g, ax):
    axes, Q, R = line(g)
    q = Q.position(axes)
    s = Sketch(ax, axes, azimuth=-60, elevation=20)
    O = (0, 0, 0)
    s.axes(O, axes, length=0.6 * R.norm(), labels=["i", "j", "k"])
    s.line((q - 0.6 * R).components(), (q + 1.5 * R).components(), style="solid")
    s.arrow(q.components(), (q + R).components(), "R")
    s.dot(Q)
    s.label(q.components(), "Q")
    s.label(O, "O")
