"""4/34: the angular motion of a disk in a turning bracket, constant rates."""

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
    omega, alpha = solve(g).values()
    return {
        "alpha_zero": {"alpha_disk": 0 * alpha},
        "P_cross_omega": {"alpha_disk": -alpha},
        "only_P": {"omega_disk": omega.without("bracket")},
    }
