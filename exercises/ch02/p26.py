"""2/26: a boom that extends faster and faster."""

from exercises.devices.truck_boom import boom, boom_steps, motion, prove_boom, sketch


def solve(g):
    return motion(*boom(g, L_ddot=g.L_ddot))


def steps(g):
    yield from boom_steps(*boom(g, L_ddot=g.L_ddot))


def prove(g):
    return prove_boom(g, L_ddot=g.L_ddot)


def mistakes(g):
    right = solve(g)
    return {
        "no_coriolis": {"a_B": right["a_B"].without("coriolis")},
        "theta_grows": solve(g.but(omega=-g.omega)),
        "inches": solve(g.but(L_dot=12 * g.L_dot, L_ddot=12 * g.L_ddot)),  # 12 in = 1 ft
        "no_centripetal": {"a_B": right["a_B"].without("centripetal")},
    }


def draw(g, ax):
    sketch(g, ax)
