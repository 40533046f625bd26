"""5/16: a centre of mass by integration."""

from mpmath import mp

from exercises import proofs
from exercises.steps import Step
from newton_euler import Frame, integral
from newton_euler.drawing import Sketch

PLATE = Frame("plate")


def height(g, x):
    return g.b * x**2 / g.a**2


def over_strips(g, f):
    """The integral over vertical strips: of f(x, y) dx, y the height of the parabola."""
    return integral(lambda x: f(x, height(g, x)), 0, g.a)


def centre(area, first_x, first_y):
    """From the area and its first moments."""
    return {"d": PLATE.vector(first_x / area, first_y / area, 0)}


def moments(g):
    return (
        over_strips(g, lambda x, y: y),
        over_strips(g, lambda x, y: x * y),
        over_strips(g, lambda x, y: y * y / 2),
    )


def solve(g):
    return centre(*moments(g))


def steps(g):
    area, first_x, first_y = moments(g)
    yield Step("area", area, "m^2", "area of the plate, the integral of y dx", "5.4")
    yield Step("Q_x", first_x, "m^3", "integral of x y dx", "5.4", "5.13")
    yield Step("Q_y", first_y, "m^3", "integral of y/2 y dx, strips having their centre at y/2",
               "5.4", "5.13")  # fmt: skip


def prove(g):
    """By horizontal strips, from the parabola to x = a."""

    def strips(f):
        return proofs.integral(lambda y: f(g.a * mp.sqrt(y / g.b), y), 0, g.b)

    area = strips(lambda x, y: g.a - x)
    first_x, first_y = strips(lambda x, y: (g.a**2 - x**2) / 2), strips(lambda x, y: y * (g.a - x))
    return {"d": [first_x / area, first_y / area, 0]}


def mistakes(g):
    area, first_x, first_y = moments(g)
    box, box_x, box_y = g.a * g.b, g.a**2 * g.b / 2, g.a * g.b**2 / 2
    return {
        "triangle": {"d": PLATE.vector(2 * g.a / 3, g.b / 3, 0)},
        "top_of_strip": centre(area, first_x, 2 * first_y),
        "above": centre(box - area, box_x - first_x, box_y - first_y),
    }


def draw(g, ax):
    s = Sketch(ax, PLATE, plane="xy")
    O, end = (0, 0, 0), (g.a, 0, 0)
    edge = [(g.a * n / 40, height(g, g.a * n / 40), 0) for n in range(41)]
    s.axes(O, PLATE, length=1.3 * max(g.a, g.b), labels=["x", "y", ""])
    s.plate([*edge, end])
    s.dimension(O, end, label="a")
    s.dimension(end, edge[-1], label="b")
    s.label(O, "O")
