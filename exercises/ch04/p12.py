"""4/12: a bar on a rod that moves about a ball joint, from two components of one velocity."""

from exercises.devices import bar_on_ball_joint as device
from exercises.devices.bar_on_ball_joint import draw, follows, prove, solve, steps
from exercises.tools import in_frame


def mistakes(g):
    ground, _, A, _ = device.joint_motion(g)
    at_rest = in_frame(ground, {"v_D": -A.velocity(ground) / 2})
    return {**device.mistakes(g), "B_at_rest": at_rest}
