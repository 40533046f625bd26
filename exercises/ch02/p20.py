"""2/20: a collar on a rod that reverses."""

from exercises.devices import collar_on_rod
from newton_euler import pi

r = lambda g, t: g.c_2 * t**2 - g.c_3 * t**3
no_half_pi = lambda g, t: g.q_1 * t - g.q_2 * t**2
theta = lambda g, t: pi(g.q_1) / 2 * no_half_pi(g, t)
solve, steps, prove, draw = collar_on_rod.moving_by(r, theta)


def mistakes(g):
    return {
        **collar_on_rod.common_mistakes(g, r, theta),
        "no_half_pi": collar_on_rod.motion(g, r, no_half_pi),
    }
