"""4/22: the angular velocity of a disk rolling in a circle."""

from exercises.devices.rolling_disk import (
    axle_and_disk,
    orientation,
    proved_steps,
    rolling_spin,
    rolling_steps,
    sketch,
    turning,
)
from exercises.tools import in_frame, proofs, terms


def answers(g, spin):
    ground, axle, disk, _ = axle_and_disk(g, spin)
    return in_frame(axle, {"omega_disk": disk.angular_velocity(ground)})


def solve(g):
    return answers(g, rolling_spin(g))


def steps(g):
    yield from rolling_steps(g)
    yield from terms(solve(g)["omega_disk"], "omega_disk", "rad/s", "4.9")


def prove(g):
    return {"omega_disk": proofs.angular_velocity(orientation(g))} | proved_steps(g)


def mistakes(g):
    return {
        "spin_only": {"omega_disk": solve(g)["omega_disk"].without("axle")},
        "spin_reversed": answers(g, -rolling_spin(g)),
        "one_turn_each_circuit": answers(g, -turning(g)),
        "ratio_inverted": answers(g, -turning(g) * g.r / g.R),
    }


def draw(g, ax):
    sketch(g, ax, with_A=False)
