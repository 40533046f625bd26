"""11/27: how far a spherical pendulum descends from a horizontal start."""

from exercises.devices import spherical_pendulum as pendulum
from exercises.tools import on_ground, proofs
from newton_euler import asin, pi, sqrt
from newton_euler.dynamics import weight_potential


def sine(g, share=1):
    return pendulum.sine_of_descent(g.m, g.l, g.u_0 / g.l, g.g, share)


def solve(g):
    return {"angle": asin(sine(g))}


def steps(g):
    T_0, H = pendulum.level_motion(g.m, g.l, 0 * g.l, g.u_0 / g.l)
    return {"T_0": T_0, "H": H, "n": T_0 / weight_potential(g.m, g.l, g.g)}


def prove(g):
    """The motion under the weight and the force of the rod, until it rises again."""
    place, _ = pendulum.other_level(g.g, 0 * g.l, g.l, g.u_0)
    r, v = pendulum.start(0 * g.l, g.l, g.u_0)[:3], [0, g.u_0, 0]
    return {"angle": pendulum.depth_angle(place), "H": g.m * proofs.cross(r, v)[2]}


def mistakes(g):
    right = solve(g)["angle"]
    quarter = pi(right) / 2
    return {
        "straight_below": {"angle": quarter},
        "from_vertical": {"angle": quarter - right},
        "no_half": {"angle": asin(sine(g, share=2))},
        "arm_l": {"angle": 0 * right},
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=-60, elevation=18)
    places = pendulum.way(g.g, 0, g.l, g.u_0, 3 * sqrt(g.l / g.g), 120)
    lowest = min(range(len(places)), key=lambda n: places[n][2])
    places = places[: lowest + 1]
    O, B, end = (0, 0, 0), places[0], places[-1]
    above = (end[0], end[1], 0)
    s.ring(O, ground.k, g.l)
    s.path(places)
    s.rod(O, B)
    s.line(O, end)
    s.line(O, above, style="dotted")
    s.arc(O, above, end, label="angle")
    s.ball_joint(O)
    s.dot(B)
    s.dot(end)
    s.vector(B, ground.j * g.u_0, "$u_0$", kind="velocity")
    s.label(ground.i * (g.l / 2), "l", offset=(0, 10), bold=False)
    s.label(O, "O", offset=(10, 14))
    s.label(B, "m", offset=(6, -24), bold=False)
