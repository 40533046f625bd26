"""4/12: a bar on a rod that moves about a ball joint, from two components of one velocity."""

from exercises.devices import bar_on_ball_joint
from exercises.tools import in_frame

solve, prove, draw = bar_on_ball_joint.solve, bar_on_ball_joint.prove, bar_on_ball_joint.draw
follows, steps = bar_on_ball_joint.follows, bar_on_ball_joint.steps


def mistakes(g):
    ground, _, A, _ = bar_on_ball_joint.joint_motion(g)
    at_rest = in_frame(ground, {"v_D": -A.velocity(ground) / 2})
    return {**bar_on_ball_joint.mistakes(g), "B_at_rest": at_rest}
