"""2/27: a boom lowered at an increasing rate."""

from exercises.devices.truck_boom import draw, prove, solve, steps


def mistakes(g):
    right = solve(g)
    return {
        "alpha_upward": {"a_B": solve(g.but(alpha=-g.alpha))["a_B"]},
        "no_alpha_x_r": {"a_B": right["a_B"].without("euler")},
        "no_coriolis": {"a_B": right["a_B"].without("coriolis")},
        "inches": solve(g.but(L_dot=12 * g.L_dot)),  # 12 in = 1 ft
    }
