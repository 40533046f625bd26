"""4/13: the bar on a ball joint of 4/12 with the other sense of omega_x."""

from exercises.devices import bar_on_ball_joint as device
from exercises.devices.bar_on_ball_joint import draw, follows, prove, solve, steps


def mistakes(g):
    other = solve(g.but(omega_x=-g.omega_x))
    reversed_too = {key: -v for key, v in other.items()}
    return {**device.mistakes(g), "whole_omega_reversed": reversed_too}
