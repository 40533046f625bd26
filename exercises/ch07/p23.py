"""7/23: the error of taking a far cylinder for a particle."""

from exercises.tools import Sketch, disk, mean, mp
from newton_euler import Frame, bodies
from newton_euler.bodies import ring as thin_tube

END = Frame("end")
follows = {"trend": lambda g, err_1, err_2: trend(err_1, err_2)}


def about(q, body):
    """The :class:`Inertia` at G and at O, of a body of radius and mass 1."""
    I = body.inertia
    return I, I.about(END.point("O", -q, 0, 0))


def shortfall(q, body):
    """The error of m d^2: the moment about the body's own axis over the whole moment."""
    own, whole = about(q, body)
    return own.moment("z") / whole.moment("z")


def one(g):
    return bodies.cylinder(g.one, g.one, END, "z", mass=g.one)


def trend(first, second):
    """The answer on the trend, from both errors."""
    return "improves" if second < first else "worsens"


def solve(g):
    first, second = (shortfall(q, one(g)) for q in (g.q1, g.q2))
    return {"trend": lambda: trend(first, second), "err_1": first, "err_2": second}


def steps(g):
    (_, first), (_, second) = about(g.q1, one(g)), about(g.q2, one(g))
    return {"exact_1": first.moment("z"), "exact_2": second.moment("z")}


def prove(g):
    whole = lambda q: mean(lambda p: (p[0] + q) ** 2 + p[1] ** 2, disk(mp.mpf(1)))
    error = lambda q: 1 - q**2 / whole(q)
    return {
        "trend": lambda: trend(error(g.q1), error(g.q2)),
        "err_1": error(g.q1),
        "err_2": error(g.q2),
        "exact_1": whole(g.q1),
        "exact_2": whole(g.q2),
    }


def mistakes(g):
    errors = lambda error: {"err_1": error(g.q1), "err_2": error(g.q2)}
    exact = lambda q: shortfall(q, one(g))
    of_approximation = lambda q: exact(q) / (1 - exact(q))
    return {
        "of_the_approximation": {"err_2": of_approximation(g.q2)},  # nearly right at q1
        "ring": errors(lambda q: shortfall(q, thin_tube(g.one, END, "z", mass=g.one))),
        "what_is_there": errors(lambda q: 1 - shortfall(q, one(g))),
        "distance": {"trend": lambda: trend(g.q1, g.q2)},
        "diameter": errors(lambda q: shortfall(2 * q, one(g))),
    }


def draw(g, ax):
    s = Sketch(ax, END, plane="xy")
    G, O, edge = (0, 0, 0), (-g.q2, 0, 0), (0.6, 0.8, 0)
    s.disk(G, END.k, 1)
    s.line(O, G, style="centre")
    s.arrow(G, edge, "r")
    s.dimension(O, G, label="d", offset=-1.25)
    s.dot(G, "G", offset=(10, -10))
    s.dot(O, "O", offset=(-10, 8))
