"""2/19: a collar on a rod that turns faster and faster."""

from exercises.devices.collar_on_rod import (
    collar,
    collar_steps,
    common_mistakes,
    motion,
    prove_collar,
    sketch,
)


def r(g, t):
    return g.c_2 * t**2 - g.c_3 * t**3


def theta(g, t):
    return g.q * t**2


def solve(g):
    return motion(*collar(g, r, theta))


def steps(g):
    yield from collar_steps(*collar(g, r, theta))


def prove(g):
    return prove_collar(g, r, theta)


def mistakes(g):
    right = solve(g)
    return {
        **common_mistakes(*collar(g, r, theta)),
        "no_transverse": {"v": right["v"].without("transverse")},
    }


def draw(g, ax):
    sketch(g, ax, r)
