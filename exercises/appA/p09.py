"""A/9: the derivative of a vector function; numbers that vary besides the symbol t, no figure."""

from exercises.tools import rate
from newton_euler import Frame, moving


def at_time(g, t):
    """The axes, and u as a point in them, where t runs at the rate 1."""
    axes, t = Frame("axes"), moving(t, rate=g.one)
    return axes, axes.point("u", g.c_1 * t**2, g.c_2 * t**2 - g.c_3, -(t - g.c_4 * t**2))


def derivative(g, t):
    axes, u = at_time(g, t)
    return u.velocity(axes)


def solve(g):
    return {"dudt": derivative(g, g.t), "dudt_1": derivative(g, g.t_1)}


def steps(g):
    axes, u = at_time(g, g.t)
    return {"u": u.position(axes)}


def prove(g):
    def after(start):
        def u(s):
            t = start + s
            return [g.c_1 * t**2, g.c_2 * t**2 - g.c_3, -t + g.c_4 * t**2]

        return u

    return {"dudt": rate(after(g.t)), "dudt_1": rate(after(g.t_1)), "u": after(g.t)(0)}


def mistakes(g):
    right, k = solve(g), Frame("axes").k
    lost = {"dudt": 4 * g.c_4 * g.t, "dudt_1": 4 * g.c_4 * g.t_1}
    return {
        "minus_to_first_term": {key: v - lost[key] * v.frame.k for key, v in right.items()},
        "number_first": {"dudt_1": 0 * g.c_1 * k},
        "keeps_constant": {key: v - g.c_3 * v.frame.j for key, v in right.items()},
    }
