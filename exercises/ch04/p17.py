"""4/17: the elbow arm of 4/16 at an acute angle, the rod leaning back over the shaft."""

from exercises.devices import elbow_arm as device
from exercises.devices.elbow_arm import draw, follows, prove, solve, steps
from exercises.tools import in_frame


def mistakes(g):
    ground, arm, rod, _ = device.arm_and_rod(g)
    outward = arm.rotate("rod", "x", angle=g.beta_1, rate=g.b_dot, origin=rod.origin)
    moves = device.motion(outward.point("D", 0, g.L, 0), ground)
    moves["alpha_CD"] = outward.angular_acceleration(ground)
    return device.common_mistakes(g) | in_frame(ground, {"CD_outward": moves})
