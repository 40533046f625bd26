"""4/22: the angular velocity of a disk rolling in a circle."""

from exercises.devices import rolling_disk as device
from exercises.tools import in_frame, proofs, terms


def solve(g, spin=None):
    ground, axle, disk, _ = device.axle_and_disk(g, spin)
    return in_frame(axle, {"omega_disk": disk.angular_velocity(ground)})


def steps(g):
    yield from device.rolling_steps(g)
    yield from terms(solve(g)["omega_disk"], "omega_disk", "rad/s", "4.9")


def prove(g):
    return {"omega_disk": proofs.angular_velocity(device.orientation(g))} | device.proved_steps(g)


def mistakes(g):
    return {
        "spin_only": {"omega_disk": solve(g)["omega_disk"].without("axle")},
        "spin_reversed": solve(g, -device.rolling_spin(g)),
        "one_turn_each_circuit": solve(g, -device.turning(g)),
        "ratio_inverted": solve(g, -device.turning(g) * g.r / g.R),
    }


def draw(g, ax):
    device.sketch(g, ax, with_A=False)
