"""6/6: a block on a smooth plane, pulled by a hanging one."""

from exercises.devices import roped_blocks as device
from exercises.tools import mp
from newton_euler import pi

follows = {"T": lambda g, a_B: g.W_B * (1 - a_B / g.g)}


def blocks(g):
    return device.on_face(g, "A", g.W_A, g.beta), device.hanging(g, "B", g.W_B)


def solve(g):
    found = device.motion(*blocks(g))
    return {"a_B": -found.second, "T": found.T}


def steps(g):
    A, B = blocks(g)
    yield from device.block_steps(A, B, "T - W_At = m_A*a_A and W_B - T = m_B*a_A")


def prove(g):
    A = lambda s: [s * mp.cos(g.beta), s * mp.sin(g.beta)]
    a, T = device.by_energy(g, g.W_A, g.W_B, (A, lambda s: [0, -s]), 10 * g.g)
    return {"a_B": a, "T": T}


def mistakes(g):
    """The tension, too, where it follows from the wrong acceleration of B."""
    return {
        "no_slope": solve(g.but(beta=0 * g.beta)),
        "cosine": solve(g.but(beta=pi(g.beta) / 2 - g.beta)),
        "T_is_W_B": {"T": g.W_B},
        "mass_of_B": {"a_B": solve(g)["a_B"] * (g.W_A + g.W_B) / g.W_B},
    }


def draw(g, ax):
    device.draw_wedge(ax, (g.beta, r"$\beta$"))
