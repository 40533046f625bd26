"""A/18: the derivative of R x R', by a moving point."""

from exercises.tools import cross, proofs
from newton_euler import Frame, moving

AXES = Frame("axes")


def point(g):
    """The place R, with its two derivatives as velocity and acceleration."""
    coordinates = (g.x, g.xdot, g.xddot), (g.y, g.ydot, g.yddot), (g.z, g.zdot, g.zddot)
    return AXES.point("P", *(moving(*q) for q in coordinates))


def product(g):
    """R x R'."""
    P = point(g)
    return P.position(AXES).cross(P.velocity(AXES))


def solve(g):
    v = point(g).velocity(AXES)
    return {"rate": product(g).rate(AXES), "extra": v.cross(v)}


def steps(g):
    return {"w": product(g)}


def prove(g):
    """Differences along a path with these derivatives at t = 0."""

    def R(t):
        start = ((g.x, g.xdot, g.xddot), (g.y, g.ydot, g.yddot), (g.z, g.zdot, g.zddot))
        return [q + v * t + a * t**2 / 2 for q, v, a in start]

    def product(t):
        v = [g.xdot + g.xddot * t, g.ydot + g.yddot * t, g.zdot + g.zddot * t]
        return cross(R(t), v)

    v = proofs.rate(R)
    return {"rate": proofs.rate(product), "extra": cross(v, v), "w": cross(R(0), v)}


def mistakes(g):
    P = point(g)
    return {
        "only_extra": {"rate": 0 * solve(g)["rate"]},
        "product_of_derivatives": {"rate": P.velocity(AXES).cross(P.acceleration(AXES))},
        "order": {"rate": P.acceleration(AXES).cross(P.position(AXES))},
    }
