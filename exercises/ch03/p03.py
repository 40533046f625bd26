"""3/3: constant speed on a parametric curve."""

from exercises.tools import Sketch, rate, scaled, size
from newton_euler import Frame, kinematics, moving

GROUND = Frame("ground")


def curve(g):
    return lambda q: (g.a * q, g.b * q**2, g.c * q**3)


def motion(g, q):
    P = GROUND.point("P", *curve(g)(q))
    return {"v": P.velocity(GROUND), "acc": P.acceleration(GROUND)}


def parameter(g):
    """q = 1 with its rates."""
    return kinematics.at_speed(curve(g), g.one, g.nu)


def solve(g):
    return motion(g, parameter(g))


def steps(g):
    q = parameter(g)
    return {"q_dot": q.rate, "q_ddot": q.acceleration}


def prove(g):
    """v along the tangent, a from its rotation along the path, without rates of q."""
    along = lambda q: rate(lambda p: [g.a * p, g.b * p**2, g.c * p**3], q)
    tangent = lambda q: scaled(1 / size(along(q)), along(q))
    a_n = g.nu**2 / size(along(1))
    return {"v": scaled(g.nu, tangent(1)), "acc": scaled(a_n, rate(tangent, 1))}


def mistakes(g):
    return {
        "q_uniform": {"acc": motion(g, moving(g.one, rate=parameter(g).rate))["acc"]},
        "no_acceleration": {"acc": 0 * solve(g)["acc"]},
        "q_rate_is_nu": motion(g, moving(g.one, rate=g.nu)),
    }


def draw(g, ax):
    s = Sketch(ax, GROUND, azimuth=-60, elevation=22)
    O, X, Q, P = (0, 0, 0), (g.a, 0, 0), (g.a, g.b, 0), (g.a, g.b, g.c)
    s.axes(O, GROUND, length=1.2 * max(g.a, g.b, g.c))
    s.path([curve(g)(n / 40) for n in range(49)])
    for A, B, label in ((X, Q, "b"), (Q, P, "c")):
        s.line(A, B)
        s.dimension(A, B, label=label)
    s.dimension(O, X, label="a")
    s.vector(P, solve(g)["v"], "$\\mathbf{v}$")
    s.dot(P, "P")
    s.label(O, "O")
