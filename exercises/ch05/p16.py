"""5/16: a centre of mass by integration."""

from exercises.devices import plate_under_curve as plate
from exercises.devices.parabola_plate import draw, height, start
from exercises.tools import proofs

moments, solve, steps = plate.centre_of(lambda g: g.a, height)


def prove(g):
    """By horizontal strips, from the parabola to x = a."""
    strips = lambda f: proofs.integral(lambda y: f(start(g, y), y), 0, g.b)
    area = strips(lambda x, y: g.a - x)
    first_x, first_y = strips(lambda x, y: (g.a**2 - x**2) / 2), strips(lambda x, y: y * (g.a - x))
    return {"d": [first_x / area, first_y / area, 0]}


def mistakes(g):
    area, first_x, first_y = moments(g)
    box, box_x, box_y = g.a * g.b, g.a**2 * g.b / 2, g.a * g.b**2 / 2
    return {
        "triangle": {"d": plate.PLATE.vector(2 * g.a / 3, g.b / 3, 0)},
        "top_of_strip": plate.centre(area, first_x, 2 * first_y),
        "above": plate.centre(box - area, box_x - first_x, box_y - first_y),
    }
