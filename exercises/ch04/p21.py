"""4/21: the angular velocity of a shaft in a tilting universal joint."""

from exercises.devices import universal_joint as device
from exercises.tools import in_frame, proofs, terms
from newton_euler import pi

draw = device.draw


def solve(g):
    return {"omega_A": device.angular_velocity(g)}


def steps(g):
    yield device.direction(g)
    yield from terms(device.angular_velocity(g), "omega_A", "rad/s", "4.9")


def prove(g):
    shaft = device.orientation(g)
    return {"omega_A": proofs.angular_velocity(shaft), "e": proofs.transposed(shaft(0))[0]}


def mistakes(g):
    _, fork, _ = device.fork_and_shaft(g)
    omega = device.angular_velocity(g)
    return in_frame(fork, {
        "no_tilting": {"omega_A": omega.without("block")},
        "tilting_reversed": solve(g.but(gamma_rate=-g.gamma_rate)),
        "gamma_from_horizontal": solve(g.but(gamma_1=pi(g.gamma_1) / 2 - g.gamma_1)),
        "no_fork": {"omega_A": omega.without("fork")},
    })  # fmt: skip
