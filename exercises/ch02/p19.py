"""2/19: a collar on an accelerating rod."""

from exercises.devices import collar_on_rod

r = lambda g, t: g.c_2 * t**2 - g.c_3 * t**3
theta = lambda g, t: g.q * t**2
solve, steps, prove, draw = collar_on_rod.moving_by(r, theta)


def mistakes(g):
    return {
        **collar_on_rod.common_mistakes(g, r, theta),
        "no_transverse": {"v": solve(g)["v"].without("transverse")},
    }
