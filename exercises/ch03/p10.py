"""3/10: an acceleration at right angles to the velocity, or nearly so; flexure."""

from exercises.devices.instant_of_motion import GROUND, figure, speed_and_flexure, vectors
from exercises.tools import minus, plus, size
from newton_euler.kinematics import flexure, speed_rate

follows = {"speed_rate": lambda g, v_dot_a: v_dot_a / vectors(g)[0].norm()}


def solve(g):
    v, a = vectors(g)
    return {"v_dot_a": v.dot(a), "speed_rate": speed_rate(v, a), "flexure": flexure(v, a)}


def steps(g):
    v, a = vectors(g)
    return {"speed": v.norm(), "a_n": v.cross(a).norm() / v.norm()}


def prove(g):
    """The scalar product from the two diagonals of the parallelogram of v and a."""
    v, a = [g.v_x, g.v_y, g.v_z], [g.a_x, g.a_y, g.a_z]
    rate_of_speed, f = speed_and_flexure(v, a)
    product = (size(plus(v, a)) ** 2 - size(minus(v, a)) ** 2) / 4
    return {"v_dot_a": product, "speed_rate": rate_of_speed, "flexure": f}


def mistakes(g):
    v, a = vectors(g)
    sizes = [GROUND.vector(*map(abs, u)) for u in (v, a)]
    product = sizes[0].dot(sizes[1])
    return {
        "radius": {"flexure": 1 / flexure(v, a)},
        "speed_not_squared": {"flexure": flexure(v, a) * v.norm()},
        "whole_in_flexure": {"flexure": a.norm() / v.norm() ** 2},
        "whole_acceleration": {"speed_rate": a.norm()},
        "signs_dropped": {"v_dot_a": product, "speed_rate": product / v.norm()},
    }


def draw(g, ax):
    v, a = vectors(g)
    s, T = figure(ax, v, a, "", azimuth=-60, elevation=25)
    s.axes(0.4 * T * v.norm() * GROUND.k - v * T, GROUND, length=0.5 * T * v.norm())
