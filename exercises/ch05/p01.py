"""5/1: the centre of mass of a triangle by integration."""

from exercises.devices import plate_under_curve as plate
from exercises.devices.triangular_plate import area_points, draw, height

moments, solve, steps = plate.centre_of(lambda g: g.b, height)


def prove(g):
    """By the mass points of a square, mapped to the triangle."""
    points = area_points(g)
    area = sum(A for A, _ in points)
    first_x, first_y = (sum(A * place[n] for A, place in points) for n in range(2))
    d = [first_x / area, first_y / area, 0]
    return {"d": d, "area": area, "Q_x": first_x, "Q_y": first_y}


def mistakes(g):
    area, first_x, first_y = moments(g)
    return {
        "rectangle": {"d": plate.PLATE.vector(g.b / 2, g.h / 2, 0)},
        "from_far_corners": {"d": plate.PLATE.vector(g.b, g.h, 0) - solve(g)["d"]},
        "top_of_strip": plate.centre(area, first_x, 2 * first_y),
    }
