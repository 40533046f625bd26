"""Six figures of chapter 4, for the tests of sliders: {name: (figure, its arguments)}."""

from math import radians

from newton_euler import Frame, moving
from newton_euler.chapters.figures import ch04


def crane(tilt, speed):
    """Ground, column, boom and trolley of a crane that turns while its boom rises."""
    ground = Frame("ground")
    column = ground.rotate("column", "z", rate=0.6, acceleration=0.2)
    hinge = column.point("B", 0, 0.5, 1.0)
    boom = column.rotate("boom", "x", angle=moving(radians(tilt), 0.4, -0.1), origin=hinge)
    return ground, column, boom, boom.point("A", 0, moving(3.0, speed, 0.3), 0)


FIGURES = {
    "crane": (ch04.crane, {"build": crane}),
    "bead on a rod": (ch04.moving_frame, {}),
    "Euler's theorem": (ch04.eulers_theorem, {}),
    "two orders": (ch04.two_orders, {}),
    "terms": (ch04.acceleration_terms, {"build": crane}),
    "carried round": (ch04.carried_round, {}),
}
