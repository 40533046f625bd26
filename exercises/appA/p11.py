"""A/11: gradients, by the engine's exact derivatives; formulas and a vector of numbers."""

from exercises.tools import proofs
from newton_euler import Frame
from newton_euler.kinematics.curvilinear_systems import gradient

AXES = Frame("axes")


def at_point(g, V):
    return gradient(V, AXES.point("P", g.x, g.y, g.z))


def products(g):
    """The three terms of (c)."""
    return {
        "xy": lambda x, y, z: g.A * x * y,
        "yz": lambda x, y, z: g.B * y * z,
        "xz": lambda x, y, z: g.C * x * z,
    }


def functions(g):
    return {
        "grad_a": lambda x, y, z: g.p * x + g.q * y + g.r * z,
        "grad_b": lambda x, y, z: -g.A * x**2 * y,
        "grad_c": lambda x, y, z: sum(V(x, y, z) for V in products(g).values()),
    }


def solve(g):
    return {key: at_point(g, V) for key, V in functions(g).items()}


def steps(g):
    return {f"grad_{name}": at_point(g, V) for name, V in products(g).items()}


def prove(g):
    """By slopes along slanted lines, of the functions written differently."""
    written = {
        "grad_a": lambda x, y, z: g.r * z + g.q * y + g.p * x,
        "grad_b": lambda x, y, z: -y * g.A * x * x,
        "grad_c": lambda x, y, z: y * (g.A * x + g.B * z) + g.C * z * x,
        "grad_xy": lambda x, y, z: y * g.A * x,
        "grad_yz": lambda x, y, z: z * g.B * y,
        "grad_xz": lambda x, y, z: z * g.C * x,
    }
    return {key: proofs.gradient(V, [g.x, g.y, g.z]) for key, V in written.items()}


def mistakes(g):
    b = solve(g)["grad_b"]
    return {
        "only_by_x": {"grad_b": b.x * AXES.i},
        "one_factor": {"grad_c": AXES.vector(g.A * g.y, g.B * g.z, g.C * g.x)},
        "plus": {"grad_b": -b},
    }
