"""2/4: grain falling into a chute."""

from exercises.tools import on_ground, root
from newton_euler import sqrt


def fall_time(g):
    """The time of the fall from rest through the height h."""
    return sqrt(2 * g.h / g.g)


def speeds(g, T):
    """The speeds that reach the near and the far edge in the time T."""
    return g.d / T, (g.d + g.w) / T


def solve(g):
    return {"v_0": speeds(g, fall_time(g))}


def steps(g):
    return {"T": fall_time(g), "x_far": g.d + g.w}


def prove(g):
    """The speeds at which the grain falls by h on its way to each edge."""
    speed = lambda edge: root(lambda v: g.h - g.g / 2 * (edge / v) ** 2, edge / 100, 100 * edge)
    return {"v_0": [speed(g.d), speed(g.d + g.w)]}


def mistakes(g):
    T = fall_time(g)
    return {
        "far_edge_at_w": {"v_0": (g.w / T, g.d / T)},
        "no_2": {"v_0": speeds(g, sqrt(g.h / g.g))},
        "no_root": {"v_0": speeds(g, T**2)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    deep = -g.h - 0.4 * g.h
    for v in solve(g)["v_0"]:
        T = fall_time(g)
        s.path([(v * T * n / 40, 0, -g.h * (n / 40) ** 2) for n in range(41)])
    for x in (g.d, g.d + g.w):
        s.line((x, 0, -g.h), (x, 0, deep), style="solid")
    s.rod((-0.25 * g.d, 0, 0), (0, 0, 0))
    s.vector((0, 0, 0), ground.i, "$v_0$")
    s.dimension((0, 0, deep), (g.d, 0, deep), label="d")
    s.dimension((g.d, 0, deep), (g.d + g.w, 0, deep), label="w")
    s.dimension((0, 0, 0), (0, 0, -g.h), label="h", offset=0.1 * g.d)
