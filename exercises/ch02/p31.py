"""2/31: the acceleration of a car as it is seen from another one that turns."""

from exercises.devices import two_cars
from exercises.devices.two_cars import (
    acceleration_steps,
    cars,
    draw,
    seen_acceleration,
    seen_velocity,
)

__all__ = ["draw", "mistakes", "prove", "solve", "steps"]


def solve(g):
    return {"a_rel": seen_acceleration(*cars(g))}


def steps(g):
    yield from acceleration_steps(*cars(g))


def prove(g):
    velocities, accelerations = two_cars.prove(g)
    return accelerations | velocities


def mistakes(g):
    scene = cars(g)
    v_B_minus_v_A = seen_velocity(*scene, lambda v: v.without("rotation"))
    return {
        "no_coriolis": {"a_rel": seen_acceleration(*scene, "coriolis")},
        "a_B_minus_a_A": {"a_rel": seen_acceleration(*scene, "coriolis", "euler", "centripetal")},
        "not_v_rel": {"a_rel": seen_acceleration(*scene, seen=v_B_minus_v_A)},
        "no_centripetal": {"a_rel": seen_acceleration(*scene, "centripetal")},
    }
