"""2/30: the velocity of a car as seen from another one that turns."""

from exercises.devices import two_cars as device
from exercises.devices.two_cars import cars, seen_velocity

draw, prove = device.draw, device.proved_velocities


def solve(g):
    return {"v_rel": seen_velocity(*cars(g))}


def steps(g):
    yield from device.velocity_steps(*cars(g))


def mistakes(g):
    wrong = lambda **factors: {"v_rel": seen_velocity(*cars(g), lambda v: v.reweighted(**factors))}
    return {
        "no_turning": wrong(rotation=0),
        "clockwise": wrong(rotation=-1),
        "radius_R_plus_x": wrong(rotation=g.R / (g.R + g.x)),
        "km_per_h": solve(g.but(v=g.stated("v"))),
    }
