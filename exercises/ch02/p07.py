"""2/7: the highest strike on a wall."""

from exercises.devices import thrown_ball
from newton_euler import asin, atan, pi, sin


def solve(g):
    u = thrown_ball.best_slope(g)
    return {"h": thrown_ball.at_wall(g, u)[0], "gam": atan(u)}


def steps(g):
    return {"c": g.g * g.d**2 / (2 * g.v_0**2)}


def prove(g):
    gam = thrown_ball.proved_angle(g)
    return {"h": thrown_ball.proved_height(g, gam), "gam": gam}


def mistakes(g):
    quarter = pi(g.one) / 4
    apex = 2 * quarter - asin(2 * g.g * g.d / g.v_0**2) / 2
    most = g.v_0**2 / (2 * g.g)
    return {
        "greatest_range": {"h": thrown_ball.at_wall(g, g.one)[0], "gam": quarter},
        "apex_at_wall": {"h": most * sin(apex) ** 2, "gam": apex},
        "highest_apex": {"h": most, "gam": 2 * quarter},
        "from_vertical": {"gam": 2 * quarter - solve(g)["gam"]},
    }


def draw(g, ax):
    s, O, foot, hit, ahead = thrown_ball.draw(g, ax)
    s.arc(O, foot, ahead, label=r"$\gamma$")
    s.dimension(foot, hit, "h")
