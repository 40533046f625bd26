"""3/11: flexure from the magnitude and the direction of the acceleration."""

from exercises.devices.instant_of_motion import figure, speed_and_flexure
from exercises.tools import mp, rot, scaled, size, times
from newton_euler import Frame, atan2, cos, pi, sin
from newton_euler.kinematics import flexure, speed_rate


def vectors(g):
    """v, and a turned from it by the angle, to the left."""
    ground = Frame("ground")
    v = ground.vector(g.v_x, g.v_y, 0)
    along = ground.rotate("along v", "z", angle=atan2(g.v_y, g.v_x))
    return v, along.vector(g.a_mag * cos(g.angle), g.a_mag * sin(g.angle), 0)


def solve(g):
    v, a = vectors(g)
    return {"flexure": flexure(v, a), "a_t": speed_rate(v, a)}


def steps(g):
    v, a = vectors(g)
    return {"speed": v.norm(), "a_n": v.cross(a).norm() / v.norm()}


def prove(g):
    v = [g.v_x, g.v_y, mp.zero]
    a = scaled(g.a_mag / size(v), times(rot("z", -g.angle), v))  # to the right
    a_t, f = speed_and_flexure(v, a)
    return {"flexure": f, "a_t": a_t}


def mistakes(g):
    right, (v, a) = solve(g), vectors(g)
    return {
        "sine_for_cosine": solve(g.but(angle=pi(g.angle) / 2 - g.angle)),
        "whole_acceleration": {"flexure": a.norm() / v.dot(v)},
        "radius": {"flexure": 1 / right["flexure"]},
    }


def draw(g, ax):
    v, a = vectors(g)
    s, T = figure(ax, v, a, r"$\alpha$", plane="xy")
    corner = (0.9 * T * v.x, -0.9 * T * v.y, 0)
    s.axes(corner, v.frame, length=0.4 * T * v.norm(), labels=["x", "y", ""])
