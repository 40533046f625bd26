"""A/16: components for which three vectors are orthogonal, one condition after the other."""

from exercises.tools import cross, proofs
from newton_euler import Frame, solve_linear

AXES = Frame("axes")
P = lambda g: AXES.vector(g.p_1, g.p_2, g.p_3)
Q = lambda g, z: AXES.vector(g.q_1, 0, z)
R = lambda g, x, y: AXES.vector(g.r_1, x, y)


def z(g):
    return solve_linear(lambda z: P(g).dot(Q(g, z))).z


def y(g, z):
    """Whatever x is, since Q has no component along j."""
    return solve_linear(lambda y: Q(g, z).dot(R(g, 0, y))).y


def x(g, y):
    return solve_linear(lambda x: P(g).dot(R(g, x, y))).x


follows = {"y": y, "x": x}


def solve(g):
    known = z(g)
    then = y(g, known)
    return {"z": known, "y": then, "x": x(g, then)}


def steps(g):
    return {
        "known_PQ": g.p_1 * g.q_1,
        "known_QR": g.q_1 * g.r_1,
        "known_PR": P(g).dot(R(g, 0, y(g, z(g)))),
    }


def prove(g):
    """z by Pythagoras for the triangle of P and Q; R is along P x Q."""
    P = [g.p_1, g.p_2, g.p_3]

    def gap(z):
        Q = [g.q_1, 0, z]
        return sum((p - q) ** 2 - p**2 - q**2 for p, q in zip(P, Q, strict=True))

    z = proofs.root(gap, -100, 100)
    normal = cross(P, [g.q_1, 0, z])
    return {"z": z, "y": g.r_1 * normal[2] / normal[0], "x": g.r_1 * normal[1] / normal[0]}


def mistakes(g):
    """Later answers follow from a wrong z or y by ``follows``."""
    right = solve(g)
    return {
        "z_sign": {"z": -right["z"]},
        "exchanged": {"y": right["x"], "x": right["y"]},
        "y_sign": {"y": -right["y"]},
    }
