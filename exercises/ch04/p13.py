"""4/13: the bar on a ball joint of 4/12 with the other sense of omega_x."""

from exercises.devices import bar_on_ball_joint

solve, prove, draw = bar_on_ball_joint.solve, bar_on_ball_joint.prove, bar_on_ball_joint.draw
follows, steps = bar_on_ball_joint.follows, bar_on_ball_joint.steps


def mistakes(g):
    other = solve(g.but(omega_x=-g.omega_x))
    reversed_too = {key: -v for key, v in other.items()}
    return {**bar_on_ball_joint.mistakes(g), "whole_omega_reversed": reversed_too}
