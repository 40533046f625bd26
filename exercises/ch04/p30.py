"""4/30: the angular acceleration of a disk rolling in a circle, and the acceleration of a rim
point.
"""

from exercises.catalogue import in_frame
from exercises.devices.rolling_disk import (
    axle_and_disk,
    orientation,
    rim_point,
    rolling_spin,
    sketch,
)
from exercises.proofs import angular_acceleration, second_rate


def answers(g, spin):
    ground, axle, disk, A = axle_and_disk(g, spin)
    return in_frame(
        axle,
        {"alpha_disk": disk.angular_acceleration(ground), "a_A": A.acceleration(ground, via=axle)},
    )


def solve(g):
    return answers(g, rolling_spin(g))


def prove(g):
    return {"alpha_disk": angular_acceleration(orientation(g)), "a_A": second_rate(rim_point(g))}


def mistakes(g):
    right = solve(g)
    return {
        "zero": {"alpha_disk": 0 * right["alpha_disk"]},
        "C_not_accelerated": {"a_A": right["a_A"].without("origin")},
        "no_turning_about_vertical": {"a_A": right["a_A"].without("centripetal")},
        "spin_reversed": {"alpha_disk": answers(g, -rolling_spin(g))["alpha_disk"]},
    }


def draw(g, ax):
    sketch(g, ax)
