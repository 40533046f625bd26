"""5/22: the degrees of freedom of a pendulum on a cart. The length is only drawn."""

from exercises.tools import freedom, mp, mpf, on_ground
from newton_euler import dynamics

BODIES = {"cart": "body in plane", "P": "particle in plane"}
# the hinge C, which locates the cart, stays at its height, and the cart stays level
track = lambda cart: cart[1:]
# P stays at unit distance from C
rod = lambda cart, P: (P[0] - cart[0]) ** 2 + (P[1] - cart[1]) ** 2 - 1


def count(**constraints):
    return dynamics.degrees_of_freedom(BODIES, constraints)


def solve(g):
    return {"dof": count(track=track, rod=rod)}


def steps(g):
    return {"coordinates": count().unknowns, "track": 2, "rod": 1}


def prove(g):
    """By the displacement of the cart and the angle of the rod."""
    return {"dof": freedom(lambda x, q: [x, x + mp.sin(q), -mp.cos(q)], mpf(2), mpf("0.4"))}


def mistakes(g):
    return {
        "cart_given": {"dof": count(track=track, rod=rod, given=lambda cart: cart[0])},
        "no_rod": {"dof": count(track=track)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    L = g.L
    # the pendulum is in front of cart and track
    C, P = (0, -0.3 * L, 0), (0.28 * L, -0.3 * L, -0.96 * L)
    s.road([(-1.2 * L, 0, -0.35 * L), (1.2 * L, 0, -0.35 * L)])
    s.box((0, 0, 0), ground, (1.3 * L, 0.3 * L, 0.3 * L))
    for x in (-0.45 * L, 0.45 * L):
        s.disk((x, 0, -0.25 * L), ground.j, 0.1 * L)
    s.rod(C, P)
    s.hinge(C)
    s.dimension(C, P, label="L", offset=0.12 * L)
    s.dot(P, "P")
    s.label(C, "C", offset=(-12, 4))
