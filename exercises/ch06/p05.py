"""6/5: Atwood's machine."""

from exercises.devices.atwood import draw_machine
from exercises.devices.roped_blocks import block_steps, by_energy, hanging, motion
from exercises.tools import on_ground

follows = {"a_B": lambda g, a_A: a_A, "T": lambda g, a_A: g.W_A * (1 - a_A / g.g)}


def blocks(g):
    return hanging(g, "B", g.W_B), hanging(g, "A", g.W_A)


def solve(g):
    found = motion(*blocks(g))
    return {"a_A": -found.second, "a_B": found.first, "T": found.T}


def steps(g):
    B, A = blocks(g)
    yield from block_steps(B, A, "T - W_B = m_B*a_B and W_A - T = m_A*a_B")


def prove(g):
    """By the energy; the side of B shortens, so that A and B exchange their roles."""
    a, T = by_energy(g, g.W_B, g.W_A, (lambda s: [1, s], lambda s: [0, -s]), 10 * g.g)
    return {"a_A": a, "a_B": a, "T": T}


def mistakes(g):
    a = solve(g)["a_A"]
    of_A = a * (g.W_A + g.W_B) / g.W_A
    return {
        "mass_of_A": {"a_A": of_A, "a_B": of_A},
        "T_is_W_B": {"T": g.W_B},
        "T_is_W_A": {"T": g.W_A},
        "weights_as_masses": dict.fromkeys(("a_A", "a_B"), a / g.stated("g")),
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    draw_machine(s, ground, ("", 0.8, (2.4, "A"), (1.9, "B")))
