"""4/37: the angular motion of a disk in a turning bracket, growing rates."""

from exercises.devices.disk_in_bracket import (
    alpha_disk,
    disk_in_bracket,
    figure,
    prove_turning,
    turning,
    turning_steps,
)

draw, prove, steps = figure, prove_turning, turning_steps
follows = {"alpha_disk": alpha_disk}


def solve(g):
    return turning(disk_in_bracket(g))


def mistakes(g):
    alpha = solve(g)["alpha_disk"]
    return {
        "no_product": {"alpha_disk": alpha.without("bracket x disk")},
        "product_reversed": {"alpha_disk": alpha.reweighted(**{"bracket x disk": -1})},
        "no_omega_dot": {"alpha_disk": alpha.without("bracket")},
        "no_P_dot": {"alpha_disk": alpha.without("disk")},
    }
