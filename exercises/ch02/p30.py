"""2/30: the velocity of a car as seen from another one that turns."""

from exercises.devices import two_cars
from exercises.devices.two_cars import cars, draw, seen_velocity, velocity_steps

__all__ = ["draw", "mistakes", "prove", "solve", "steps"]


def solve(g):
    return {"v_rel": seen_velocity(*cars(g))}


def steps(g):
    yield from velocity_steps(*cars(g))


def prove(g):
    velocities, _ = two_cars.prove(g)
    return velocities


def mistakes(g):
    def wrong(**factors):
        return {"v_rel": seen_velocity(*cars(g), lambda v: v.reweighted(**factors))}

    return {
        "no_turning": wrong(rotation=0),
        "clockwise": wrong(rotation=-1),
        "radius_R_plus_x": wrong(rotation=g.R / (g.R + g.x)),
        "km_per_h": solve(g.but(v=g.stated("v"))),
    }
