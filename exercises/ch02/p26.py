"""2/26: a boom extending at an increasing rate."""

from exercises.devices.truck_boom import draw, prove, solve, steps


def mistakes(g):
    right = solve(g)
    return {
        "no_coriolis": {"a_B": right["a_B"].without("coriolis")},
        "theta_grows": solve(g.but(omega=-g.omega)),
        "inches": solve(g.but(L_dot=12 * g.L_dot, L_ddot=12 * g.L_ddot)),  # 12 in = 1 ft
        "no_centripetal": {"a_B": right["a_B"].without("centripetal")},
    }
