"""4/21: the angular velocity of a shaft in a tilting universal joint."""

from exercises import proofs
from exercises.catalogue import in_frame
from exercises.devices.universal_joint import angular_velocity, draw, fork_and_shaft, orientation
from newton_euler import pi

__all__ = ["draw", "mistakes", "prove", "solve"]


def solve(g):
    return {"omega_A": angular_velocity(g)}


def prove(g):
    return {"omega_A": proofs.angular_velocity(orientation(g))}


def mistakes(g):
    _, fork, _ = fork_and_shaft(g)
    omega = angular_velocity(g)
    return in_frame(fork, {
        "no_tilting": {"omega_A": omega.without("block")},
        "tilting_reversed": solve(g.but(gamma_rate=-g.gamma_rate)),
        "gamma_from_horizontal": solve(g.but(gamma_1=pi(g.gamma_1) / 2 - g.gamma_1)),
        "no_fork": {"omega_A": omega.without("fork")},
    })  # fmt: skip
