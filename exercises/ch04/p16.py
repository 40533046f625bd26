"""4/16: the rod CD, hinged at C to an arm BC that turns about the vertical, at an obtuse angle."""

from exercises.devices.elbow_arm import (
    arm_and_rod,
    common_mistakes,
    draw,
    follows,
    prove,
    solve,
    steps,
)
from exercises.tools import in_frame
from newton_euler import cos, moving, sin

__all__ = ["draw", "follows", "mistakes", "prove", "solve", "steps"]


def mistakes(g):
    ground, arm, _, D = arm_and_rod(g)
    beta = moving(g.beta_1, rate=g.b_dot)
    from_vertical = arm.point("D", 0, g.b + g.L * sin(beta), g.L * cos(beta))
    return common_mistakes(g) | in_frame(ground, {
        "C_at_rest": {
            "v_D": D.velocity(ground).without("origin"),
            "a_D": D.acceleration(ground).without("origin"),
        },
        "beta_from_the_vertical": {
            "v_D": from_vertical.velocity(ground),
            "a_D": from_vertical.acceleration(ground),
        },
    })  # fmt: skip
