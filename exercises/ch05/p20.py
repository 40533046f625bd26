"""5/20: the degrees of freedom of a pendulum: a count is an int. The length is only drawn."""

from exercises.tools import freedom, mp, mpf, on_ground
from newton_euler import dynamics

SPACE, PLANE = "particle", "particle in plane"
rod = lambda P: sum(x * x for x in P) - 1  # P stays at unit distance from O


def count(kind, **constraints):
    return dynamics.degrees_of_freedom({"P": kind}, constraints)


def solve(g):
    return {"dof": count(PLANE, rod=rod)}


def steps(g):
    return {"coordinates": count(PLANE).unknowns, "constraints": 1}


def prove(g):
    """By the angle that locates P."""
    return {"dof": freedom(lambda q: [mp.sin(q), -mp.cos(q)], mpf("0.4"))}


def mistakes(g):
    return {
        "no_rod": {"dof": count(PLANE)},
        "no_plane": {"dof": count(SPACE, rod=rod)},
        "neither": {"dof": count(SPACE)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    O, P = (0, 0, 0), (0.5 * g.L, 0, -(0.75**0.5) * g.L)
    s.ground(O, normal=-ground.k)
    s.rod(O, P)
    s.hinge(O)
    s.line(O, (0, 0, -g.L))
    s.dimension(O, P, label="L", offset=0.12 * g.L)
    s.label(O, "O", offset=(-14, -14))
    s.dot(P, "P")
