"""3/9: the angle between velocity and acceleration, and the rate of the speed."""

from exercises.devices import instant_of_motion as device
from newton_euler import acos, asin, cos, kinematics

follows = {"speed_rate": lambda g, angle: device.vectors(g)[1].norm() * cos(angle)}


def solve(g):
    v, a = device.vectors(g)
    cosine = v.dot(a) / (v.norm() * a.norm())
    return {"angle": acos(cosine), "speed_rate": kinematics.speed_rate(v, a)}


def steps(g):
    v, a = device.vectors(g)
    return {"product": v.dot(a), "speed": v.norm(), "a_size": a.norm()}


def prove(g):
    v, a = [g.v_x, g.v_y, g.v_z], [g.a_x, g.a_y, g.a_z]
    return {"angle": device.angle_between(v, a), "speed_rate": device.speed_and_flexure(v, a)[0]}


def mistakes(g):
    v, a = device.vectors(g)
    product = v.dot(a)
    return {
        "whole_acceleration": {"speed_rate": a.norm()},
        "v_along_a": {"speed_rate": product / a.norm()},
        "arc_sine": {"angle": asin(product / (v.norm() * a.norm()))},
        "not_divided": {"speed_rate": product},
    }


def draw(g, ax):
    v, a = device.vectors(g)
    s, T = device.figure(ax, v, a, r"$\alpha$", azimuth=-70, elevation=20)
    foot = -0.9 * T * v - 0.5 * T * T * a.norm() * device.GROUND.k
    s.axes(foot, device.GROUND, length=0.4 * T * v.norm())
