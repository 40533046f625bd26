"""5/1: the centre of mass of a triangle by integration."""

from mpmath import mpf

from exercises import proofs
from exercises.steps import Step
from newton_euler import Frame, integral
from newton_euler.drawing import Sketch

PLATE = Frame("plate")


def height(g, x):
    return g.h * (1 - x / g.b)


def over_strips(g, f):
    """The integral over vertical strips: of f(x, y) dx, y the height of the hypotenuse."""
    return integral(lambda x: f(x, height(g, x)), 0, g.b)


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
    """By the mass points of a square, which is moved to the triangle: its lower edge to O, its
    upper edge to the hypotenuse.
    """

    def moments(place):
        u, v = place[0] + 1 / mpf(2), place[1] + 1 / mpf(2)
        x, y, dA = v * g.b * (1 - u), v * g.h * u, g.b * g.h * v
        return [dA, x * dA, y * dA]

    area, first_x, first_y = proofs.mean(moments, proofs.box(1, 1, 0))
    d = [first_x / area, first_y / area, 0]
    return {"d": d, "area": area, "Q_x": first_x, "Q_y": first_y}


def mistakes(g):
    area, first_x, first_y = moments(g)
    return {
        "rectangle": {"d": PLATE.vector(g.b / 2, g.h / 2, 0)},
        "from_far_corners": {"d": PLATE.vector(g.b, g.h, 0) - solve(g)["d"]},
        "top_of_strip": centre(area, first_x, 2 * first_y),
    }


def draw(g, ax):
    s = Sketch(ax, PLATE, plane="xy")
    O, B, H = (0, 0, 0), (g.b, 0, 0), (0, g.h, 0)
    s.axes(O, PLATE, length=1.3 * max(g.b, g.h), labels=["x", "y", ""])
    s.plate([O, B, H])
    x, end = 0.4 * g.b, 0.45 * g.b
    strip = [(x, 0, 0), (end, 0, 0), (end, height(g, end), 0), (x, height(g, x), 0)]
    s.plate(strip, shade="dark")
    s.dimension(O, B, label="b")
    s.dimension(O, H, label="h")
    s.dimension((x, 0.3 * g.h, 0), (end, 0.3 * g.h, 0), label="dx", offset=0)
    s.label(O, "O")
