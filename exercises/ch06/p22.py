"""6/22: where a shot straight up lands on the turning Earth, a word and a formula."""

from exercises.devices.turning_earth import flight, globe, ground_axes, shot, to_first_order
from exercises.tools import root
from newton_euler import pi

follows = {"side": lambda g, x: answers(x)["side"]}


def answers(x):
    """The answers; the word says on which side the shot lands."""
    side = lambda: "east" if x > 0 else "west" if x < 0 else "same point"
    return {"side": side, "x": x}


def way(g):
    """The displacement from launch to landing, to first order, with its terms."""
    return shot(g, 2 * g.v_0 / g.g, g.v_0 * ground_axes(g).k)


def solve(g):
    return answers(way(g).x)


def steps(g):
    drift = way(g).terms
    x_launch, x_fall = drift["launch turned"].x, drift["fall turned"].x
    return {"t_f": 2 * g.v_0 / g.g, "x_launch": x_launch, "x_fall": x_fall}


def prove(g):
    """The free flight in the inertial frame, to the ground."""
    place, top = flight(g, [0, 0, g.v_0]), g.v_0 / g.g

    def down(share):
        t = root(lambda t: place(t, share)[2], top, 3 * top)
        return [t, place(t, share)[0]]

    t_f, x = to_first_order(down)
    return answers(x) | {"t_f": t_f}


def mistakes(g):
    r = way(g)
    return {
        "undone": answers(0 * r.x),
        "dropped_from_the_top": answers(shot(g, g.v_0 / g.g, ground_axes(g).vector(0, 0, 0)).x),
        "no_fall_turned": {"x": r.without("fall turned").x},
        "sine": {"x": solve(g.but(lat=pi(g.lat) / 2 - g.lat))["x"]},
    }


def draw(g, ax):
    s, ground = globe(g, ax)
    s.vector(ground.point("above", 0, 0, 0.6), ground.k, "$v_0$", kind="velocity")
