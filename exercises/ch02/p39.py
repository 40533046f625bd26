"""2/39: the other end of the rod of 2/36."""

from exercises.devices import sliding_rod
from exercises.devices.turning_plate import acceleration_from

end, solve, steps, prove, draw = sliding_rod.about("E", 1)
follows = {"a_E": lambda g, v_E: acceleration_from(*end(g), v_E)}


def mistakes(g):
    return sliding_rod.common_mistakes(g, end, "x_E")
