"""4/29: the angular acceleration of the shaft of 4/21."""

from exercises import proofs
from exercises.devices.universal_joint import angular_acceleration, draw, orientation

__all__ = ["draw", "mistakes", "prove", "solve"]


def solve(g):
    return {"alpha_A": angular_acceleration(g)}


def prove(g):
    return {"alpha_A": proofs.angular_acceleration(orientation(g))}


def mistakes(g):
    alpha = angular_acceleration(g)
    return {
        "zero": {"alpha_A": 0 * alpha},
        "no_fork_x_tilting": {"alpha_A": alpha.without("fork x block")},
        "e_fixed_in_fork": {"alpha_A": alpha.without("block x shaft")},
        "rates_in_turning_fork": {"alpha_A": alpha.without("fork x block", "fork x shaft")},
        "tilting_reversed": solve(g.but(gamma_rate=-g.gamma_rate)),
    }
