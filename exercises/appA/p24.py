"""A/24: the integral of a cross product; numbers that vary besides a symbol; no figure."""

from exercises.tools import proofs
from newton_euler import Frame, integral

AXES = Frame("axes")
A = lambda g, t: AXES.vector(g.c_1 * t, -(g.c_2 * t**2 + g.c_3), 0)
B = lambda g, t: AXES.vector(-g.b_1 * t**2, 0, g.b_2)


def solve(g):
    return {"AxB": integral(lambda t: A(g, t).cross(B(g, t)), 0, g.t)}


def steps(g):
    return {"integrand": A(g, g.t).cross(B(g, g.t))}


def prove(g):
    def product(t):
        return proofs.cross([g.c_1 * t, -g.c_2 * t**2 - g.c_3, 0], [-g.b_1 * t**2, 0, g.b_2])

    return {"AxB": proofs.integral(product, 0, g.t), "integrand": product(g.t)}


def mistakes(g):
    right = solve(g)["AxB"]
    x, y, z = right.components()
    each = [integral(lambda t, f=f: f(g, t), 0, g.t) for f in (A, B)]
    return {
        "each_first": {"AxB": each[0].cross(each[1])},
        "j_sign": {"AxB": AXES.vector(x, -y, z)},
        "B_x_A": {"AxB": -right},
        "not_integrated": {"AxB": A(g, g.t).cross(B(g, g.t))},
    }
