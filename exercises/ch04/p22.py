"""4/22: the angular velocity of a disk rolling in a circle."""

from exercises import proofs
from exercises.answering import in_frame
from exercises.ch04.scene_rolling_disk import orientation, rolling_disk, rolling_ratio, sketch


def solve(g, ratio=None):
    ground, axle, disk, _ = rolling_disk(g, ratio)
    return in_frame(axle, {"omega_disk": disk.angular_velocity(ground)})


def prove(g):
    return {"omega_disk": proofs.angular_velocity(orientation(g))}


def mistakes(g):
    return {
        "spin_only": {"omega_disk": solve(g)["omega_disk"].without("arm")},
        "spin_reversed": solve(g, -rolling_ratio(g)),
        "one_turn_each_circuit": solve(g, -1),
        "ratio_inverted": solve(g, -g.r / g.R),
    }


def draw(g, ax):
    sketch(g, ax, with_A=False)
