"""4/16: the rod CD, hinged at C to an arm BC that turns about the vertical, at an obtuse angle."""

from exercises.devices import elbow_arm as device
from exercises.tools import in_frame
from newton_euler import cos, moving, sin

solve, steps, prove = device.solve, device.steps, device.prove
follows, draw = device.follows, device.draw


def mistakes(g):
    ground, arm, _, D = device.arm_and_rod(g)
    beta = moving(g.beta_1, rate=g.b_dot)
    from_vertical = arm.point("D", 0, g.b + g.L * sin(beta), g.L * cos(beta))
    return device.common_mistakes(g) | in_frame(ground, {
        "C_at_rest": {
            "v_D": D.velocity(ground).without("origin"),
            "a_D": D.acceleration(ground).without("origin"),
        },
        "beta_from_the_vertical": {
            "v_D": from_vertical.velocity(ground),
            "a_D": from_vertical.acceleration(ground),
        },
    })  # fmt: skip
