"""4/22: the angular velocity of a disk rolling in a circle."""

from exercises import proofs
from exercises.catalogue import in_frame
from exercises.devices.rolling_disk import axle_and_disk, orientation, rolling_spin, sketch, turning


def answers(g, spin):
    ground, axle, disk, _ = axle_and_disk(g, spin)
    return in_frame(axle, {"omega_disk": disk.angular_velocity(ground)})


def solve(g):
    return answers(g, rolling_spin(g))


def prove(g):
    return {"omega_disk": proofs.angular_velocity(orientation(g))}


def mistakes(g):
    return {
        "spin_only": {"omega_disk": solve(g)["omega_disk"].without("arm")},
        "spin_reversed": answers(g, -rolling_spin(g)),
        "one_turn_each_circuit": answers(g, -turning(g)),
        "ratio_inverted": answers(g, -turning(g) * g.r / g.R),
    }


def draw(g, ax):
    sketch(g, ax, with_A=False)
