"""2/9: an airplane whose passengers are weightless."""

from exercises.tools import Sketch, Step, mp, rate, size
from newton_euler import Frame, frenet, sqrt


def over_the_top(g):
    """The motion in intrinsic components: level, with the acceleration of what falls freely."""
    ground = Frame("ground")
    return frenet(ground.vector(g.v, 0, 0), ground.vector(0, 0, -g.g))


def solve(g):
    P = over_the_top(g)
    return {"gam_dot": P.speed * P.flexure}


def steps(g):
    P = over_the_top(g)
    yield Step(
        "a_n",
        P.acceleration.y,
        "m/s^2",
        "normal component of the acceleration, since the passengers fall freely",
        "2.3",
        "2.14",
    )
    yield Step("rho", P.radius, "m", "radius of curvature of the path at the top", "2.3", "2.14")


def prove(g):
    """The angle of the velocity on the parabola of what falls freely, as a function of time."""

    def place(t):
        return [g.v * t, 0, -g.g * t**2 / 2]

    def angle(t):
        ahead, _, up = rate(place, t)
        return mp.atan2(-up, ahead)

    return {"gam_dot": rate(angle), "rho": size(rate(place)) / rate(angle)}


def mistakes(g):
    return {
        "km_per_hour": solve(g.but(v=g.stated("v"))),
        "no_speed": {"gam_dot": sqrt(g.g / g.v)},
        "no_acceleration": {"gam_dot": 0 * solve(g)["gam_dot"]},
    }


def draw(g, ax):
    ground = Frame("ground")
    s = Sketch(ax, ground, plane="xz")
    L = g.v**2 / g.g

    def place(x):
        return (x * L, 0, -(x**2) * L / 2)

    top, later = place(0), place(0.55)
    s.path([place(n / 40) for n in range(-32, 37)])
    s.dot(top)
    s.vector(top, ground.i, "v")
    level = (later[0] + 0.4 * L, 0, later[2])
    down = (level[0], 0, level[2] - 0.55 * 0.4 * L)  # along the path
    s.line(later, level)
    s.line(later, down, style="solid")
    s.arc(later, level, down, r"$\gamma$")
