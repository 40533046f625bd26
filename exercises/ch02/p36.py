"""2/36: an end of a rod sliding in a turning bracket."""

from exercises.devices import sliding_rod
from exercises.devices.turning_plate import acceleration_from

end, solve, steps, prove, draw = sliding_rod.about("B", -1)
follows = {"a_B": lambda g, v_B: acceleration_from(*end(g), v_B)}


def mistakes(g):
    return sliding_rod.common_mistakes(g, end, "x_B")
