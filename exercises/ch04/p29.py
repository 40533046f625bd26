"""4/29: the angular acceleration of the shaft of 4/21."""

from exercises.devices import universal_joint as device
from exercises.tools import proofs, terms

draw = device.draw


def solve(g):
    return {"alpha_A": device.angular_acceleration(g)}


def steps(g):
    ground, fork, shaft = device.fork_and_shaft(g)
    yield device.direction(g)
    yield "omega_fork", fork.angular_velocity(ground).expressed_in(fork)
    yield "omega_block", shaft.parent.angular_velocity(fork).expressed_in(fork)
    yield "omega_shaft", shaft.angular_velocity(shaft.parent).expressed_in(fork)
    yield from terms(device.angular_acceleration(g), "alpha_A", "rad/s^2", "4.9", "4.26")


def prove(g):
    shaft = device.orientation(g)
    return {"alpha_A": proofs.angular_acceleration(shaft), "e": proofs.transposed(shaft(0))[0]}


def mistakes(g):
    alpha = device.angular_acceleration(g)
    return {
        "zero": {"alpha_A": 0 * alpha},
        "no_fork_x_tilting": {"alpha_A": alpha.without("fork x block")},
        "e_fixed_in_fork": {"alpha_A": alpha.without("block x shaft")},
        "rates_in_turning_fork": {"alpha_A": alpha.without("fork x block", "fork x shaft")},
        "tilting_reversed": solve(g.but(gamma_rate=-g.gamma_rate)),
    }
