"""2/31: the acceleration of a car as seen from another one that turns."""

from exercises.devices import two_cars as device

solve, steps, prove, draw = device.solve, device.steps, device.prove, device.draw


def mistakes(g):
    scene = device.cars(g)
    v_B_minus_v_A = device.seen_velocity(*scene, lambda v: v.without("rotation"))
    without = lambda *names: {"a_rel": device.seen_acceleration(*scene, *names)}
    return {
        "no_coriolis": without("coriolis"),
        "a_B_minus_a_A": without("coriolis", "euler", "centripetal"),
        "not_v_rel": {"a_rel": device.seen_acceleration(*scene, seen=v_B_minus_v_A)},
        "no_centripetal": without("centripetal"),
    }
