"""6/17: a particle sliding through a dip and over a crest."""

from exercises.tools import Sketch, cross, mp, mpf, rate, second_rate, size
from exercises.tools import root as place_of
from newton_euler import Frame, cos, sin, solve_linear, tan
from newton_euler.dynamics import path_force, speed_after


def speed(g, h):
    """Speed after a smooth slide from rest through the height h."""
    return speed_after(0, g.m * g.g * h, g.m)


def pressed(g, across):
    """The track's upward force for mass times upward acceleration ``across``."""
    return across + g.m * g.g


def solve(g):
    _, at_B = path_force(g.m, speed(g, g.h_B), 0, 1 / g.rho_B)
    v_C = speed(g, g.h_C)
    # -across: the centre of curvature is below
    s = solve_linear(lambda flexure: pressed(g, -path_force(g.m, v_C, 0, flexure)[1]))
    return {"F_B": pressed(g, at_B), "rho_C": 1 / s.flexure}


def steps(g):
    return {"v_B": speed(g, g.h_B), "a_B": speed(g, g.h_B) ** 2 / g.rho_B, "v_C": speed(g, g.h_C)}


def prove(g):
    """By the speed of free fall: at B on a circle, at C by the curvature of free flight."""

    def fallen(h):
        depth = lambda t: g.g * t**2 / 2
        return rate(depth, place_of(lambda t: depth(t) - h, 0, 1 + h / g.g))

    v_B, v_C = fallen(g.h_B), fallen(g.h_C)
    angle = lambda t: v_B * t / g.rho_B
    on_circle = lambda t: [g.rho_B * mp.sin(angle(t)), -g.rho_B * mp.cos(angle(t)), 0]
    in_flight = lambda t: [v_C * t, -g.g * t**2 / 2, mpf(0)]
    a_B, v, a = second_rate(on_circle)[1], rate(in_flight), second_rate(in_flight)
    answers = {"F_B": g.m * (a_B + g.g), "rho_C": size(v) ** 3 / size(cross(v, a))}
    return answers | {"v_B": v_B, "a_B": a_B, "v_C": v_C}


def mistakes(g):
    F_B = solve(g)["F_B"]
    return {
        "no_weight": {"F_B": F_B - g.m * g.g},
        "as_on_a_crest": {"F_B": F_B - 2 * g.m * g.g},
        "half_the_square": solve(g.but(h_B=g.h_B / 2, h_C=g.h_C / 2)),
        "height_above_B": {"rho_C": solve(g.but(h_C=g.h_B - g.h_C))["rho_C"]},
    }


DOWN, UP = 0.8, 0.55  # slopes of the track before and after B, rad


def bend(centre, radius, first, last):
    """An arc of the track, its slope from ``first`` to ``last``; a negative radius for a crest."""
    slopes = [first + (last - first) * n / 16 for n in range(17)]
    return [(centre[0] + radius * sin(q), 0, centre[1] - radius * cos(q)) for q in slopes]


def draw(g, ax):
    s = Sketch(ax, Frame("ground"), plane="xz")
    rho_C = g.h_B  # the drawing's own, large enough to be smooth
    dip = bend((0, g.rho_B - g.h_B), g.rho_B, -DOWN, UP)
    (x_0, _, z_0), (x_1, _, z_1) = dip[0], dip[-1]
    rise = -g.h_C - rho_C * (1 - cos(UP)) - z_1  # height of the straight piece before the crest
    x_C = x_1 + rise / tan(UP) + rho_C * sin(UP)
    crest = bend((x_C, -g.h_C - rho_C), -rho_C, UP, -0.3)
    A, B, C = (x_0 + z_0 / tan(DOWN), 0, 0), (0, 0, -g.h_B), (x_C, 0, -g.h_C)
    s.road([A, *dip, *crest])
    for P, name in ((A, "A"), (B, "B"), (C, "C")):
        s.dot(P, name)
    s.arrow((0, 0, g.rho_B - g.h_B), B, label=r"$\rho_B$")
    s.line(A, (1.1 * x_C, 0, 0))
    level = 0.6 * A[0]
    s.line((level, 0, -g.h_B), B)
    s.dimension((level, 0, 0), (level, 0, -g.h_B), label="$h_B$", offset=0.001)
    s.dimension(C, (x_C, 0, 0), label="$h_C$", offset=0.001)
