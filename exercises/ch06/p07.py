"""6/7: two blocks on the faces of a wedge."""

from exercises.devices import roped_blocks as device
from exercises.tools import mp
from newton_euler import pi, sin

follows = {"T": lambda g, a_A: g.W_A * (sin(g.theta_A) + a_A / g.g)}


def blocks(g):
    A = device.on_face(g, "A", g.W_A, g.theta_A)
    return A, device.on_face(g, "B", g.W_B, g.theta_B, toward=-1)


def answers(A, B):
    found = device.motion(A, B)
    return {"a_A": found.first, "T": found.T}


def solve(g):
    return answers(*blocks(g))


def steps(g):
    A, B = blocks(g)
    yield from device.block_steps(A, B, "T - W_At = m_A*a_A and W_Bt - T = m_B*a_A")


def prove(g):
    A = lambda s: [s * mp.cos(g.theta_A), s * mp.sin(g.theta_A)]
    B = lambda s: [s * mp.cos(g.theta_B), -s * mp.sin(g.theta_B)]
    a, T = device.by_energy(g, g.W_A, g.W_B, (A, B), 10 * g.g)
    return {"a_A": a, "T": T}


def mistakes(g):
    quarter = pi(g.theta_A) / 2
    return {
        "full_weights": answers(device.hanging(g, "A", g.W_A), device.hanging(g, "B", g.W_B)),
        "same_sign": solve(g.but(theta_A=-g.theta_A)),
        "mass_of_A": {"a_A": solve(g)["a_A"] * (g.W_A + g.W_B) / g.W_A},
        "cosines": solve(g.but(theta_A=quarter - g.theta_A, theta_B=quarter - g.theta_B)),
    }


def draw(g, ax):
    device.draw_wedge(ax, (g.theta_A, r"$\theta_A$"), (g.theta_B, r"$\theta_B$"))
