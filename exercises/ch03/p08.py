"""3/8: a point climbing a cylinder at an increasing rate."""

from exercises.tools import Sketch, mp, rate, second_rate, size
from newton_euler import Frame, cos, cylindrical, moving, pi, sin
from newton_euler.kinematics import along, speed_rate

GROUND = Frame("ground")


def path(g):
    turned = lambda t: g.nu * t / g.r
    up = lambda t: g.nu * t + g.a * t**2 / 2
    return lambda t: (g.r * cos(turned(t)), g.r * sin(turned(t)), up(t))


def solve(g):
    """By cylindrical components: magnitudes are the same in all systems."""
    t = moving(g.t, rate=g.one)
    ground = Frame("ground")
    P = cylindrical(ground, "P", g.r, g.nu * t / g.r, g.nu * t + g.a * t**2 / 2)
    return {"speed": P.velocity(ground).norm(), "acc_mag": P.acceleration(ground).norm()}


def motion(g):
    """Velocity and acceleration along i, j, k."""
    P = GROUND.point("P", *along(path(g), g.t))
    return P.velocity(GROUND), P.acceleration(GROUND)


def steps(g):
    v, a = motion(g)
    return {"v": v, "acc": a}


def prove(g):
    """The path on the unrolled cylinder, and the deviation of the circle from its tangent."""
    unrolled = lambda t: [g.nu * t, g.nu * t + g.a * t**2 / 2]
    in_plane = second_rate(unrolled, g.t)
    across = second_rate(lambda t: g.r - g.r * mp.cos(g.nu * (t - g.t) / g.r), g.t)
    return {"speed": size(rate(unrolled, g.t)), "acc_mag": size([*in_plane, across])}


def mistakes(g):
    v, a = motion(g)
    added = lambda vector: GROUND.vector(vector.x, vector.y, 0).norm() + vector.z
    return {
        "rate_of_the_speed": {"acc_mag": speed_rate(v, a)},
        "no_centripetal": {"acc_mag": a.z},
        "added_as_scalars": {"speed": added(v), "acc_mag": added(a)},
    }


def draw(g, ax):
    s = Sketch(ax, GROUND, azimuth=35, elevation=22)
    end = 2.7 * pi() * g.r / g.nu  # a turn and a third
    O, high = (0, 0, 0), path(g)(end)[2]
    s.axes(O, GROUND, length=2 * g.r, labels=["x", "y", ""])
    s.line(O, (0, 0, 1.05 * high), style="centre")
    for z in (0, high):
        s.ring((0, 0, z), GROUND.k, g.r)
    s.path([path(g)(end * n / 160) for n in range(161)])
    s.dimension((0, 0, high), (0, g.r, high), label="r")
    s.dot(path(g)(0.62 * end), "P")
    s.label((0, 0, 1.05 * high), "z", bold=False)
