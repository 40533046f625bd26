"""2/1: constant speed down an exponential."""

from exercises.devices.plane_curve import at_constant_speed
from exercises.tools import Sketch, in_frame, mp, scaled, size
from newton_euler import Frame, exp, moving
from newton_euler.kinematics import at_speed, frenet_along


def curve(g):
    return lambda x: (x, g.y_0 * exp(-g.k * x), 0)


def motion(g):
    """The ground, and the motion in intrinsic components."""
    ground = Frame("ground")
    return ground, frenet_along(curve(g), at_speed(curve(g), g.x_1, g.v), ground)


def solve(g):
    ground, P = motion(g)
    return in_frame(ground, {"a": P.acceleration})


def slope_and_bend(g):
    """The first and second derivatives of y with respect to x."""
    y = curve(g)(moving(g.x_1, rate=g.one))[1]
    return y.rate, y.acceleration


def steps(g):
    ground, P = motion(g)
    slope, bend = slope_and_bend(g)
    return {"slope": slope, "bend": bend, "rho": P.radius, "e_n": P.e_n.expressed_in(ground)}


def prove(g):
    a = at_constant_speed(lambda x: [x, g.y_0 * mp.exp(-g.k * x), 0], g.x_1, g.v)[1]
    return {"a": a, "rho": g.v**2 / size(a), "e_n": scaled(1 / size(a), a)}


def mistakes(g):
    ground, P = motion(g)
    uniform = ground.point("P", *curve(g)(moving(g.x_1, rate=g.v)))
    return in_frame(ground, {
        "constant_x_velocity": {"a": uniform.acceleration(ground)},
        "no_slope": {"a": P.e_n * (g.v**2 * slope_and_bend(g)[1])},
        "no_acceleration": {"a": P.acceleration.without("normal")},
    })  # fmt: skip


def draw(g, ax):
    ground, P = motion(g)
    s = Sketch(ax, ground, plane="xy")
    y = curve(g)
    end = max(1.6 * g.x_1, 3.5 / g.k)
    O, top, here = (0, 0, 0), y(0), y(g.x_1)
    s.axes(O, ground, length=1.15 * end, labels=["x", "", ""])
    s.axes(O, ground, length=1.15 * g.y_0, labels=["", "y", ""])
    s.path([y(end * n / 60) for n in range(61)])
    s.dot(here)
    s.vector(here, P.velocity, "v")
    s.dimension(O, (g.x_1, 0, 0), "$x_1$")
    s.dimension(O, top, "$y_0$")
