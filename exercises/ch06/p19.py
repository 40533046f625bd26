"""6/19: where a stone dropped on the turning Earth lands."""

from exercises.devices.turning_earth import flight, globe, ground_axes, shot, to_first_order
from exercises.tools import root
from newton_euler import pi, sqrt
from newton_euler.applications import earth_rate


def fall_time(g):
    """The time of fall, to first order independent of the rotation."""
    return sqrt(2 * g.h / g.g)


def solve(g):
    way = shot(g, fall_time(g), ground_axes(g).vector(0, 0, 0))
    return {"d": way.without("fall")}


def steps(g):
    t, north = fall_time(g), earth_rate(ground_axes(g)).y
    return {"t_f": t, "v_x": north * g.g * t**2}


def prove(g):
    """The free flight in the inertial frame, with the Earth's speed at h, to the ground."""
    place = flight(g, [0, 0, 0], g.h)
    t_0 = (2 * g.h / g.g) ** 0.5

    def landing(share):
        t = root(lambda t: place(t, share)[2], t_0 / 2, 2 * t_0)
        return [t, *place(t, share)]

    t_f, *d = to_first_order(landing)
    return {"d": d, "t_f": t_f}


def mistakes(g):
    d = solve(g)["d"]
    return {
        "turns_on_below": {"d": -d},
        "final_speed": {"d": 3 * d},
        "mean_speed": {"d": 3 * d / 2},
        "sine": solve(g.but(lat=pi(g.lat) / 2 - g.lat)),
    }


def draw(g, ax):
    s, ground = globe(g, ax)
    A = ground.point("A", 0, 0, 0.3)
    s.dot(A)
    s.label(A, "h", offset=(-14, -4), bold=False)
