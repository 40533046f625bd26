"""A/25: the integral of a vector function, without a figure."""

from exercises.tools import proofs
from newton_euler import Frame, integral

AXES = Frame("axes")


def A(g, t):
    return AXES.vector(0, t**3 + g.c * t**2, g.d)


def between(g, start, end):
    return integral(lambda t: A(g, t), start, end)


def solve(g):
    return {"whole": between(g, 0, g.t_2) - between(g, 0, g.t_1)}


def steps(g):
    return {"J_2": between(g, 0, g.t_2), "J_1": between(g, 0, g.t_1)}


def prove(g):
    return {"whole": proofs.integral(lambda t: [0, t**3 + g.c * t**2, g.d], g.t_1, g.t_2)}


def mistakes(g):
    return {
        "no_lower_limit": {"whole": between(g, 0, g.t_2)},
        "no_constant": {"whole": AXES.vector(0, solve(g)["whole"].y, 0)},
        "not_integrated": {"whole": A(g, g.t_2) - A(g, g.t_1)},
    }
