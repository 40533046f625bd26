"""4/31: speed and distance from the axis of a point of a turning cylinder."""

from exercises.tools import Sketch, rate, rot, size, times
from newton_euler import Frame, sqrt

follows = {"r": lambda g, speed: speed / g.n}


def velocity(g):
    return Frame("ground").vector(g.v_x, 0, g.v_z)


def solve(g):
    speed = velocity(g).norm()
    return {"speed": speed, "r": speed / g.n}


def steps(g):
    return {"omega": g.n}


def prove(g):
    """r by the speed at the distance 1 from the axis, a numerical derivative."""
    speed = size([g.v_x, 0, g.v_z])
    at_one = size(rate(lambda t: times(rot("y", g.n * t), [1, 0, 0])))
    return {"speed": speed, "r": speed / at_one}


def mistakes(g):
    right, total = solve(g), sqrt(g.v_x**2) + sqrt(g.v_z**2)
    return {
        "rev_per_min_as_rad_per_s": {"r": right["speed"] / g.stated("n")},
        "sum_of_components": {"speed": total, "r": total / g.n},
        "times_n": {"r": right["speed"] * g.n},
        "r_in_m": {"r": right["r"] / 1000},
    }


def draw(g, ax):
    r, v = solve(g)["r"], velocity(g)
    ground = v.frame
    # any direction normal to v
    axis = ground.vector(-g.v_z, -v.norm() / 6, g.v_x).direction()
    O, A, end = ground.point("O", 0, 0, 0), axis * (6.8 * r), axis * (4.8 * r)
    P = end + v.cross(axis).direction() * r
    s = Sketch(ax, ground, azimuth=-50, elevation=12)
    s.shaft(O, axis * (2.2 * r))
    s.cylinder(axis * (2.2 * r), end, r)
    s.shaft(end, A)
    s.axes(O, ground)
    s.turn(axis * (6.2 * r), axis, label="n")
    s.line(end, P, style="solid")
    s.dimension(end, P, label="r")
    s.vector(P, v, r"$\mathbf{v}$")
    s.label(O, "O")
    s.label(A, "A", offset=axis)
    s.label(P, "P")
