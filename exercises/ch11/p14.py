"""11/14: a central force with the cube of the distance: its test and its potential."""

from exercises.tools import gradient, on_ground, proofs, rate
from newton_euler import Frame, integral
from newton_euler.dynamics import jacobian

PAIRS = (0, 1), (1, 2), (2, 0)  # one cross derivative of each pair


def field(g):

    def force(*place):
        square = sum(q * q for q in place)
        return tuple((g.c * square - g.k) * q for q in place)

    return force


def place(g):
    return g.x, g.y, g.z


def parts(g):
    """The parts of F.r with c and with k at the end of the segment from the origin."""
    square = sum(q * q for q in place(g))
    return g.c * square**2, -g.k * square


def solve(g):
    (cubic, linear), J = parts(g), jacobian(field(g), place(g))
    cross = Frame("axes").vector(*(J[n][m] for n, m in PAIRS))
    return {"cross": cross, "V": -(cubic / 4 + linear / 2)}


def steps(g):
    cubic, linear = parts(g)
    return {"cubic": cubic, "linear": linear}


def prove(g):
    """Slopes along slanted lines, and the work along a curve."""

    def force(x, y, z):
        r = proofs.size([x, y, z])
        return [(g.c * r**3 - g.k * r) * q / r for q in (x, y, z)]

    curve = lambda q: [g.x * q, g.y * q**2, g.z * q**3]
    work = lambda q: sum(f * v for f, v in zip(force(*curve(q)), rate(curve, q), strict=True))
    slopes = [gradient(lambda *r, n=n: force(*r)[n], place(g)) for n in range(3)]
    return {"cross": [slopes[n][m] for n, m in PAIRS], "V": -proofs.integral(work, 0, 1)}


def mistakes(g):
    F, (x, y, z), right = field(g), place(g), solve(g)
    ways = (
        lambda s: F(s * x, y, z)[0] * x,
        lambda s: F(x, s * y, z)[1] * y,
        lambda s: F(x, y, s * z)[2] * z,
    )
    return {
        "plus_gradient": {"V": -right["V"]},
        "adds_all_three": {"V": -sum(integral(way, 0, 1) for way in ways)},
        "no_quarter": {"V": right["V"] - 3 * g.c * (x * x + y * y + z * z) ** 2 / 4},
        "no_attraction": {"V": solve(g.but(k=0 * g.k))["V"]},
        "half_derivative": {"cross": right["cross"] / 2},
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=30, elevation=22)
    O, P, foot = (0, 0, 0), place(g), (g.x, g.y, 0)
    s.axes(O, ground, length=0.8 * g.x)
    s.line(O, P, style="solid")
    s.line(O, foot)
    s.line(foot, P)
    s.dot(O)
    s.dot(P)
    s.vector(P, P, "$\\mathbf{F}$", kind="force")
    s.label(P, "(x, y, z)", offset=(34, -6), bold=False)
