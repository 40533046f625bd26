"""5/7: the centre of mass of a wire along an arc."""

from mpmath import mp

from exercises import proofs
from exercises.steps import Step
from newton_euler import Frame, cos, integral, sin
from newton_euler.bodies import sector
from newton_euler.drawing import Sketch

WIRE = Frame("wire")


def over(g, f):
    """The integral of f(theta) R dtheta along the wire."""
    return integral(lambda theta: f(theta) * g.R, -g.alpha, g.alpha)


def moments(g):
    return over(g, lambda theta: g.one), over(g, lambda theta: g.R * cos(theta))


def centre(length, first_x):
    return {"d": WIRE.vector(first_x / length, 0, 0)}


def solve(g):
    return centre(*moments(g))


def steps(g):
    length, first_x = moments(g)
    yield Step("length", length, "m", "length of the wire, the integral of R d(theta)", "5.4")
    yield Step("Q_x", first_x, "m^2", "integral of R cos(theta) R d(theta)", "5.4", "5.13")


def prove(g):
    """By the slope of the line from (-R, 0) to the wire, u = y/(R + x), in which the circle is a
    fraction of polynomials: its place by u, and the way along it from the rates of x and y.
    """

    def along(u):
        def place(t):
            v = u + t
            return [g.R * (1 - v * v) / (1 + v * v), 2 * g.R * v / (1 + v * v)]

        x, _ = place(0)
        ds = proofs.size(proofs.rate(place))
        return [ds, x * ds]

    steepest = mp.sin(g.alpha) / (1 + mp.cos(g.alpha))
    length, first_x = proofs.integral(along, -steepest, steepest)
    return {"d": [first_x / length, 0, 0], "length": length, "Q_x": first_x}


def mistakes(g):
    length, first_x = moments(g)
    tip = sector(g.R, g.alpha, WIRE, "z", "x", density=1)
    return {
        "sector": {"d": tip.centre.position(WIRE)},
        "on_the_wire": {"d": WIRE.vector(g.R, 0, 0)},
        "half_the_arc": centre(length, first_x / 2),
    }


def draw(g, ax):
    s = Sketch(ax, WIRE, plane="xy")
    O = (0, 0, 0)
    low = (g.R * cos(g.alpha), -g.R * sin(g.alpha), 0)
    high = (g.R * cos(g.alpha), g.R * sin(g.alpha), 0)
    s.axes(O, WIRE, length=1.35 * g.R, labels=["x", "y", ""])
    s.wire(s.around(O, low, WIRE.k, 2 * g.alpha))
    for end in (low, high):
        s.line(O, end)
        s.arc(O, (g.R, 0, 0), end, label=r"$\alpha$")
    s.dimension(O, (g.R * cos(0.4 * g.alpha), g.R * sin(0.4 * g.alpha), 0), label="R", offset=0)
    s.label(O, "O")
