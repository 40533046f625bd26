"""6/8: a weight in the bight of a rope."""

from dataclasses import replace

from exercises.devices.roped_blocks import block_steps, by_energy, hanging, motion
from exercises.tools import on_ground, root, second_rate

follows = {"a_B": lambda g, a_A: 2 * a_A, "T": lambda g, a_A: g.W_A / 2 * (1 + a_A / g.g)}


def blocks(g):
    return hanging(g, "A", g.W_A, parts=2), hanging(g, "B", g.W_B)


def answers(A, B):
    found = motion(A, B)
    return {"a_A": found.first, "a_B": -found.second, "T": found.T}


def solve(g):
    return answers(*blocks(g))


def steps(g):
    A, B = blocks(g)
    yield from block_steps(A, B, "2*T - W_A = m_A*a_A and W_B - T = 2*m_B*a_A")


def prove(g):
    """By the energy; the fixed length of the rope, from the ceiling at height 1, locates A."""
    A = lambda s: [0, root(lambda y: 2 * (1 - y) + (1 + s) - 3, -1 - abs(s), 1 + abs(s))]
    a, T = by_energy(g, g.W_A, g.W_B, (A, lambda s: [1, -s]), 10 * g.g)
    return {"a_A": second_rate(lambda t: A(a * t**2 / 2)[1]), "a_B": a, "T": T}


def mistakes(g):
    A, B = blocks(g)
    return {
        "same_acceleration": answers(replace(A, runs=1), B),
        "one_tension": answers(replace(A, pulls=1), B),
        "the_other_way": answers(replace(A, runs=1), replace(B, runs=2)),
        "as_in_statics": {"T": g.W_A / 2},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xy")
    r, size, ceiling, low = 0.4, 0.45, 1.0, -1.6
    s.road([(3.4 * r, ceiling, 0), (-3.4 * r, ceiling, 0)])
    end, axle, top = (-2 * r, ceiling, 0), (-r, low, 0), (r, 0, 0)
    A, B = (-r, low - 1, 0), (2 * r, low + 0.3, 0)
    s.rod((r, ceiling, 0), top)
    movable, fixed = s.pulley(axle, ground.k, r), s.pulley(top, ground.k, r)
    s.cable(end, movable, fixed, B)
    s.cable(axle, A)
    for name, (x, y, _) in (("A", A), ("B", B)):
        s.box((x, y - size / 2, 0), ground, (size, size, size))
        s.label((x, y - size / 2, 0), name, offset=(0, 0))
