"""4/16: the rod CD, hinged at C to an arm BC that turns about the vertical, at an obtuse angle."""

from exercises.devices import elbow_arm as device
from exercises.devices.elbow_arm import draw, follows, prove, solve, steps
from exercises.tools import in_frame
from newton_euler import cos, moving, sin


def mistakes(g):
    ground, arm, _, D = device.arm_and_rod(g)
    v, a = device.motion(D, ground).values()
    beta = moving(g.beta_1, rate=g.b_dot)
    from_vertical = arm.point("D", 0, g.b + g.L * sin(beta), g.L * cos(beta))
    return device.common_mistakes(g) | in_frame(ground, {
        "C_at_rest": {"v_D": v.without("origin"), "a_D": a.without("origin")},
        "beta_from_the_vertical": device.motion(from_vertical, ground),
    })  # fmt: skip
