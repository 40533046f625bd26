"""4/17: the elbow arm of 4/16 at an acute angle, the rod leaning back over the shaft."""

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

__all__ = ["draw", "follows", "mistakes", "prove", "solve", "steps"]


def mistakes(g):
    ground, arm, rod, _ = arm_and_rod(g)
    outward = arm.rotate("rod", "x", angle=g.beta_1, rate=g.b_dot, origin=rod.origin)
    D = outward.point("D", 0, g.L, 0)
    return common_mistakes(g) | in_frame(ground, {
        "CD_outward": {
            "alpha_CD": outward.angular_acceleration(ground),
            "v_D": D.velocity(ground),
            "a_D": D.acceleration(ground),
        },
    })  # fmt: skip
