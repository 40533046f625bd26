"""4/13: the bar on a ball joint of 4/12 with the other sense of omega_x."""

from exercises.ch04 import scene_ball_joint as scene

solve, prove, draw = scene.solve, scene.prove, scene.draw


def mistakes(g):
    other = solve(g.but(omega_x=-g.omega_x))
    return {**scene.mistakes(g), "whole_omega_reversed": {key: -v for key, v in other.items()}}
