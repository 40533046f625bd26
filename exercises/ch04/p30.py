"""4/30: the angular acceleration of a disk rolling in a circle, and a rim point's acceleration."""

from exercises.devices import rolling_disk as device
from exercises.devices.moving_frame import seen_in
from exercises.tools import angular_acceleration, in_frame, second_rate, terms

draw = device.sketch


def solve(g, spin=None):
    ground, axle, disk, A = device.axle_and_disk(g, spin)
    alpha, a = disk.angular_acceleration(ground), A.acceleration(ground, via=axle)
    return in_frame(axle, {"alpha_disk": alpha, "a_A": a})


def steps(g):
    yield from device.rolling_steps(g)
    alpha, a = solve(g).values()
    yield from terms(alpha, "alpha_disk", "rad/s^2", "4.9")
    _, axle, _, A = device.axle_and_disk(g)
    phrase = "the moving frame, fixed in the axle"
    yield from seen_in(axle, A, axle, "m", phrase, "C, the origin of the moving frame", "r_A")
    yield from terms(a, "a_A", "m/s^2", "4.8")


def prove(g):
    alpha, a = angular_acceleration(device.orientation(g)), second_rate(device.rim_point(g))
    return {"alpha_disk": alpha, "a_A": a} | device.proved_steps(g)


def mistakes(g):
    right = solve(g)
    return {
        "zero": {"alpha_disk": 0 * right["alpha_disk"]},
        "C_not_accelerated": {"a_A": right["a_A"].without("origin")},
        "no_turning_about_vertical": {"a_A": right["a_A"].without("centripetal")},
        "spin_reversed": {"alpha_disk": solve(g, -device.rolling_spin(g))["alpha_disk"]},
    }
