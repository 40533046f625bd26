"""2/29: a boom on an accelerating truck."""

from exercises.devices.truck_boom import draw, prove, solve, steps


def mistakes(g):
    v_B, a_B = solve(g).values()
    return {
        "no_a_A": {"a_B": a_B.without("origin")},
        "not_resolved": {
            "v_B": v_B.without("origin") + g.v * v_B.frame.i,
            "a_B": a_B.without("origin") + g.a * a_B.frame.i,
        },
        "wrong_sign": solve(g.but(theta=-g.theta)),
        "no_coriolis": {"a_B": a_B.without("coriolis")},
    }
