"""2/31: the acceleration of a car as seen from another one that turns."""

from exercises.devices import two_cars as device

draw = device.draw


def solve(g):
    return {"a_rel": device.seen_acceleration(*device.cars(g))}


def steps(g):
    yield from device.acceleration_steps(*device.cars(g))


def prove(g):
    velocities, accelerations = device.prove(g)
    return accelerations | velocities


def mistakes(g):
    scene = device.cars(g)
    v_B_minus_v_A = device.seen_velocity(*scene, lambda v: v.without("rotation"))
    return {
        "no_coriolis": {"a_rel": device.seen_acceleration(*scene, "coriolis")},
        "a_B_minus_a_A": {
            "a_rel": device.seen_acceleration(*scene, "coriolis", "euler", "centripetal")
        },
        "not_v_rel": {"a_rel": device.seen_acceleration(*scene, seen=v_B_minus_v_A)},
        "no_centripetal": {"a_rel": device.seen_acceleration(*scene, "centripetal")},
    }
