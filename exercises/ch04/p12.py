"""4/12: a bar on a rod that moves about a ball joint, from two components of one velocity."""

from exercises.answering import in_frame
from exercises.ch04 import scene_ball_joint as scene

solve, prove, draw = scene.solve, scene.prove, scene.draw


def mistakes(g):
    ground, _, A, _ = scene.joint_motion(g)
    return {**scene.mistakes(g), "B_at_rest": in_frame(ground, {"v_D": -A.velocity(ground) / 2})}
