"""2/29: a boom on an accelerating truck."""

from exercises.devices.truck_boom import moving_with, sketch

_, solve, steps, prove = moving_with(theta=lambda g: g.theta, v=lambda g: g.v, a=lambda g: g.a)


def mistakes(g):
    v_B, a_B = solve(g).values()
    i = v_B.frame.i
    return {
        "no_a_A": {"a_B": a_B.without("origin")},
        "not_resolved": {
            "v_B": v_B.without("origin") + g.v * i,
            "a_B": a_B.without("origin") + g.a * a_B.frame.i,
        },
        "wrong_sign": solve(g.but(theta=-g.theta)),
        "no_coriolis": {"a_B": a_B.without("coriolis")},
    }


def draw(g, ax):
    s = sketch(g, ax, g.theta)
    s.vector((0.26 * g.L, -0.2 * g.L, 0), (1, 0, 0), "v")
    s.vector((0.26 * g.L, -0.1 * g.L, 0), (1, 0, 0), "a", kind="acceleration")
