"""2/8: a ball that hits a wall as high as possible: is it rising or falling?"""

from exercises.devices import thrown_ball as device
from exercises.tools import mp, rate, root
from newton_euler import sqrt

draw = device.draw
follows = {"sense": lambda g, slope: sense(slope)}


def sense(slope):
    return "ascending" if slope > 0 else "descending"


def solve(g):
    slope = device.at_wall(g, device.best_slope(g))[1]
    # the height v_0^2/(2 g) - g d^2/(2 v_0^2) of 2/7 vanishes
    return {"slope": slope, "sense": lambda: sense(slope), "v_min": sqrt(g.g * g.d)}


def steps(g):
    u = device.best_slope(g)
    h, slope = device.at_wall(g, u)
    return {"u": u, "upward": slope * device.forward(g, u), "h": h}


def prove(g):
    gam = device.proved_angle(g)
    path = device.proved_path(g, gam)
    T = g.d / (g.v_0 * mp.cos(gam))
    ahead, upward = rate(path, T)
    slope = upward / ahead

    def speed(angle):
        """The initial speed that reaches the foot of the wall."""
        return root(lambda v: v * mp.sin(angle) - g.g / 2 * g.d / (v * mp.cos(angle)), 1e-3, 1e3)

    # least where it no longer changes with the angle
    flattest = root(lambda a: rate(lambda t: speed(a + t)), mp.mpf("0.1"), mp.mpf("1.4"))
    answers = {"slope": slope, "sense": lambda: sense(slope), "v_min": speed(flattest)}
    return answers | {"u": mp.tan(gam), "upward": upward, "h": path(T)[1]}


def mistakes(g):
    right = solve(g)
    return {
        "least_for_apex": {"v_min": sqrt(2 * g.g * g.d)},
        "apex": {"slope": 0 * right["slope"]},
        "slope_at_O": {"slope": device.best_slope(g), "sense": "ascending"},
        "sign": {"slope": -right["slope"], "sense": "ascending"},
    }
