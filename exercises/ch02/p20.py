"""2/20: a collar on a rod that turns back."""

from exercises.devices.collar_on_rod import (
    collar,
    collar_steps,
    common_mistakes,
    motion,
    prove_collar,
    sketch,
)
from newton_euler import pi


def r(g, t):
    return g.c_2 * t**2 - g.c_3 * t**3


def no_half_pi(g, t):
    return g.q_1 * t - g.q_2 * t**2


def theta(g, t):
    return pi(g.q_1) / 2 * no_half_pi(g, t)


def solve(g):
    return motion(*collar(g, r, theta))


def steps(g):
    yield from collar_steps(*collar(g, r, theta))


def prove(g):
    return prove_collar(g, r, theta)


def mistakes(g):
    return {
        **common_mistakes(*collar(g, r, theta)),
        "no_half_pi": motion(*collar(g, r, no_half_pi)),
    }


def draw(g, ax):
    sketch(g, ax, r)
