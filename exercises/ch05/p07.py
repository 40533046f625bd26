"""5/7: the centre of mass of a wire along an arc."""

from exercises.devices.put_together import on_axis
from exercises.devices.wire_arc import WIRE, along, draw, over
from newton_euler import bodies, cos


def moments(g):
    return over(g, lambda theta: g.one), over(g, lambda theta: g.R * cos(theta))


centre, solve, steps = on_axis(WIRE, "x", "length", moments)


def prove(g):
    """By the slope of the line from (-R, 0) to the wire instead of an angle."""
    length, first_x = along(g, lambda place: [1, place[0]])
    return {"d": [first_x / length, 0, 0], "length": length, "Q_x": first_x}


def mistakes(g):
    length, first_x = moments(g)
    tip = bodies.sector(g.R, g.alpha, WIRE, "z", "x", density=1)
    return {
        "sector": {"d": tip.centre.position(WIRE)},
        "on_the_wire": {"d": WIRE.vector(g.R, 0, 0)},
        "half_the_arc": centre(length, first_x / 2),
    }
