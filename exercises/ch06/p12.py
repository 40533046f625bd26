"""6/12: a car that leaves the road at a hump."""

from exercises.devices.plane_curve import at_constant_speed
from exercises.tools import mp, on_ground, root
from newton_euler import Frame, kinematics, moving, pi, sin, sqrt
from newton_euler.dynamics import path_force


def flexure(g, x):
    road = lambda x: (x, g.b * sin(2 * pi(g.L) * x / g.L), 0)
    return kinematics.frenet_along(road, moving(x, rate=g.one), Frame("ground")).flexure


def hump(g):
    """The radius of curvature at the hump."""
    return 1 / flexure(g, g.L / 4)


def speed(g):
    """The speed at which the hump needs a normal force equal to the weight."""
    return sqrt(g.g * hump(g))


def force(g, v_max):
    """The upward force of the road at the dip, which carries the weight and turns the path up."""
    return path_force(g.m, v_max, 0, flexure(g, 3 * g.L / 4))[1] + g.m * g.g


def solve(g):
    v = speed(g)
    return {"v_max": v, "F_dip": force(g, v)}


follows = {"F_dip": force}


def steps(g):
    _, F_n = path_force(g.m, speed(g), 0, flexure(g, 3 * g.L / 4))
    return {"rho": hump(g), "F_n": F_n}


def prove(g):
    """By the motion at the constant speed for which the road exerts no force at the hump."""
    place = lambda x: [x, g.b * mp.sin(2 * mp.pi * x / g.L), 0]
    push = lambda x, v: g.m * (g.g + at_constant_speed(place, x, v)[1][1])
    v = root(lambda v: push(g.L / 4, v), mp.sqrt(g.g * g.L) / 100, 100 * mp.sqrt(g.g * g.L))
    F = push(3 * g.L / 4, v)
    return {"v_max": v, "F_dip": F, "F_n": F - g.m * g.g}


def mistakes(g):
    v = solve(g)["v_max"]
    return {
        "b_is_radius": {"v_max": sqrt(g.g * g.b)},
        "no_wave_number": {"v_max": v * 2 * pi(g.L)},
        "half_wave_number": {"v_max": v * 2},
        "no_weight": {"F_dip": g.m * g.g},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    L, b = 1.0, 0.11  # the waves are exaggerated
    height = lambda x: b * sin(2 * pi(x) * x / L)
    xs = [L * n / 60 for n in range(-7, 86)]
    s.road([(x, height(x), 0) for x in xs])
    r = 0.018
    for x in (L / 4, 3 * L / 4):
        for side in (-2, 2):
            wheel = x + side * r
            s.disk((wheel, height(wheel) + r, 0), ground.k, r)
        s.box((x, height(x) + 2.6 * r, 0), ground, (7 * r, 2 * r, 2 * r))
    s.line((xs[0], 0, 0), (xs[-1], 0, 0), style="centre")
    s.dimension((0, 0, 0), (L, 0, 0), label="L", offset=-2.2 * b)
    s.dimension((1.25 * L, 0, 0), (1.25 * L, b, 0), label="b", offset=0.0)
    s.axes((0, 0, 0), ground, length=0.25, labels=["x", "y", ""])
