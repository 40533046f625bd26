"""2/27: a boom that falls faster and faster."""

from exercises.devices.truck_boom import boom, boom_steps, motion, prove_boom, sketch


def solve(g):
    return motion(*boom(g, alpha=-g.alpha))


def steps(g):
    yield from boom_steps(*boom(g, alpha=-g.alpha))


def prove(g):
    return prove_boom(g, alpha=-g.alpha)


def mistakes(g):
    right = solve(g)
    return {
        "alpha_upward": {"a_B": solve(g.but(alpha=-g.alpha))["a_B"]},
        "no_alpha_x_r": {"a_B": right["a_B"].without("euler")},
        "no_coriolis": {"a_B": right["a_B"].without("coriolis")},
        "inches": solve(g.but(L_dot=12 * g.L_dot)),  # 12 in = 1 ft
    }


def draw(g, ax):
    sketch(g, ax)
