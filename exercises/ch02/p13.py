"""2/13: velocity and acceleration along the path and across it."""

from exercises.tools import Sketch, mp, rate, second_rate
from newton_euler import Frame, cos, sin
from newton_euler.kinematics import at_speed, frenet_along

follows = {"a": lambda g, v: v.frame.vector(-g.b, v.dot(v) / g.rho, 0)}


def velocity(g):
    ground = Frame("ground")
    return ground, ground.vector(g.v_1, g.v_2, 0)


def circle(g):
    """The circle of curvature as a function of its angle, in axes along and across the path."""
    return lambda angle: (g.rho * sin(angle), g.rho * (1 - cos(angle)), 0)


def on_circle(g):
    """The motion on this circle, with the given speed and its rate."""
    here = at_speed(circle(g), 0 * g.one, velocity(g)[1].norm(), -g.b)
    return frenet_along(circle(g), here, Frame("along and across"))


def solve(g):
    P = on_circle(g)
    return {"v": P.velocity, "a": P.acceleration}


def steps(g):
    return {"speed": on_circle(g).speed}


def prove(g):
    """On a parabola with the curvature of the path."""
    speed = mp.hypot(g.v_1, g.v_2)

    def place(t):
        along = speed * t - g.b * t**2 / 2
        return [along, along**2 / (2 * g.rho), 0]

    return {"v": rate(place), "a": second_rate(place), "speed": speed}


def mistakes(g):
    P = on_circle(g)
    tangential, normal = P.acceleration.x, P.acceleration.y
    vector = P.frame.vector
    in_feet = P.speed * g.stated("v_1") / g.v_1
    return {
        "speeding_up": {"a": vector(-tangential, normal, 0)},
        "x_and_y": {"v": vector(g.v_1, g.v_2, 0)},
        "v_not_squared": {"a": vector(tangential, normal / in_feet, 0)},
    }


def draw(g, ax):
    ground, v = velocity(g)
    s = Sketch(ax, ground, plane="xy")
    e_t = v / v.norm()
    e_n = ground.k.cross(e_t)
    P, C = (0, 0, 0), (e_n * g.rho).components()

    def on_path(angle):
        along, across, _ = circle(g)(angle)
        return (e_t * along + e_n * across).components()

    s.path([on_path(n / 30) for n in range(-24, 31)])
    s.line(C, P)
    s.vector(P, e_t, "$e_t$", kind="plain")
    s.vector(P, e_n, "$e_n$", kind="plain")
    s.vector(P, -e_t, "b", kind="acceleration")
    s.axes((0.5 * g.rho, -0.8 * g.rho, 0), ground, length=0.4 * g.rho, labels=["i", "j", ""])
    s.dimension(P, C, r"$\rho$", offset=0.12 * g.rho)
    s.dot(C, "C")
    s.dot(P, "P")
