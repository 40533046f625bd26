"""2/19: a collar on a rod that turns faster and faster."""

from exercises.devices import collar_on_rod


def r(g, t):
    return g.c_2 * t**2 - g.c_3 * t**3


def theta(g, t):
    return g.q * t**2


def solve(g):
    return collar_on_rod.motion(g, r, theta)


def steps(g):
    yield from collar_on_rod.steps(g, r, theta)


def prove(g):
    return collar_on_rod.prove(g, r, theta)


def mistakes(g):
    right = solve(g)
    return {
        **collar_on_rod.common_mistakes(g, r, theta),
        "no_transverse": {"v": right["v"].without("transverse")},
    }


def draw(g, ax):
    collar_on_rod.sketch(g, ax, r)
