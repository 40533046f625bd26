"""2/9: an airplane whose passengers are weightless, or nearly so."""

from exercises.tools import mp, on_ground, rate, second_rate
from newton_euler import Frame, frenet, sqrt


def over_the_top(g):
    """The motion in intrinsic components: level, with the acceleration by weight and seat."""
    ground = Frame("ground")
    return frenet(ground.vector(g.v, 0, 0), ground.vector(0, 0, -(1 - g.n) * g.g))


def solve(g):
    P = over_the_top(g)
    return {"gam_dot": P.acceleration.y / P.speed}


def steps(g):
    return {"a_n": over_the_top(g).acceleration.y}


def prove(g):
    """The angle of the velocity on the parabola with this acceleration, as a function of time."""
    place = lambda t: [g.v * t, 0, (g.n - 1) * g.g * t**2 / 2]

    def angle(t):
        ahead, _, up = rate(place, t)
        return mp.atan2(-up, ahead)

    return {"gam_dot": rate(angle), "a_n": -second_rate(place)[2]}


def mistakes(g):
    return {
        "km_per_hour": solve(g.but(v=g.stated("v"))),
        "no_speed": {"gam_dot": sqrt((1 - g.n) * g.g / g.v)},
        "seat_for_resultant": {"gam_dot": g.n * g.g / g.v},
        "no_seat": solve(g.but(n=0 * g.n)),
        "no_acceleration": {"gam_dot": 0 * solve(g)["gam_dot"]},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    L = g.v**2 / g.g
    place = lambda x: (x * L, 0, -(x**2) * L / 2)
    top, later = place(0), place(0.55)
    s.path([place(n / 40) for n in range(-32, 37)])
    s.dot(top)
    s.vector(top, ground.i, "v")
    level = (later[0] + 0.4 * L, 0, later[2])
    down = (level[0], 0, level[2] - 0.55 * 0.4 * L)  # along the path
    s.line(later, level)
    s.line(later, down, style="solid")
    s.arc(later, level, down, r"$\gamma$")
