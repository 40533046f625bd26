"""4/23: the velocity of a rim point of a disk rolling in a circle."""

from exercises.devices import rolling_disk as device
from exercises.devices.moving_frame import seen_in
from exercises.tools import in_frame, rate, terms

draw = device.sketch


def solve(g, spin=None):
    ground, axle, _, A = device.axle_and_disk(g, spin)
    return in_frame(axle, {"v_A": A.velocity(ground, via=axle)})


def steps(g):
    yield from device.rolling_steps(g)
    _, axle, _, A = device.axle_and_disk(g)
    phrase = "the moving frame, fixed in the axle"
    start = "C, the origin of the moving frame"
    yield from seen_in(axle, A, axle, "m", phrase, start, "r_A", False)
    yield from terms(solve(g)["v_A"], "v_A", "m/s", "4.8")


def prove(g):
    return {"v_A": rate(device.rim_point(g))} | device.proved_steps(g)


def mistakes(g):
    v = solve(g)["v_A"]
    return {
        "no_turning_about_vertical": {"v_A": v.without("rotation")},
        "C_at_rest": {"v_A": v.without("origin")},
        "spin_reversed": solve(g, -device.rolling_spin(g)),
        "one_turn_each_circuit": solve(g, -device.turning(g)),
    }
