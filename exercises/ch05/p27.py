"""5/27: the degrees of freedom of a double pendulum. The lengths are only drawn."""

from exercises.tools import freedom, mp, mpf, on_ground
from newton_euler import dynamics

PLANE = {"P1": "particle in plane", "P2": "particle in plane"}
# P1 stays at unit distance from O, P2 from P1
rod_1 = lambda P1: P1[0] ** 2 + P1[1] ** 2 - 1
rod_2 = lambda P1, P2: (P2[0] - P1[0]) ** 2 + (P2[1] - P1[1]) ** 2 - 1
# the second rod continues in the direction of the first
in_one_line = lambda P1, P2: P1[0] * P2[1] - P1[1] * P2[0]


def count(**constraints):
    return dynamics.degrees_of_freedom(PLANE, constraints)


def solve(g):
    return {"dof": count(rod_1=rod_1, rod_2=rod_2)}


def steps(g):
    return {"coordinates": count().unknowns, "constraints": 2}


def prove(g):
    """By the angles of the two rods from the vertical."""

    def places(q1, q2):
        x, y = mp.sin(q1), -mp.cos(q1)
        return [x, y, x + mp.sin(q2), y - mp.cos(q2)]

    return {"dof": freedom(places, mpf("0.4"), mpf("0.9"))}


def mistakes(g):
    return {
        "no_rods": {"dof": count()},
        "one_body": {"dof": count(rod_1=rod_1, rod_2=rod_2, in_one_line=in_one_line)},
        "one_rod": {"dof": count(rod_1=rod_1)},
    }


def draw(g, ax):
    ground, s = on_ground(ax, plane="xz")
    O, P1 = (0, 0, 0), (0.28 * g.L1, 0, -0.96 * g.L1)
    P2 = (P1[0] + 0.8 * g.L2, 0, P1[2] - 0.6 * g.L2)
    s.ground(O, normal=-ground.k)
    s.rod(O, P1, P2)
    s.hinge(O)
    for P, name in ((P1, "$P_1$"), (P2, "$P_2$")):
        s.dot(P)
        s.label(P, name, offset=(0, -14), bold=False)
    s.dimension(O, P1, label="$L_1$", offset=-0.15 * g.L1)
    s.dimension(P1, P2, label="$L_2$", offset=0.15 * g.L1)
    s.label(O, "O", offset=(14, -12))
