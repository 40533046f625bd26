"""2/38: the rod of 2/36, slowing down in the bracket."""

from exercises.devices import sliding_rod
from exercises.devices.turning_plate import acceleration_from, motion

end, solve, steps, prove, draw = sliding_rod.about("B", -1)
follows = {"a_B": lambda g, v_B: acceleration_from(*end(g), v_B)}


def mistakes(g):
    return {
        "a_rel_forward": {"a_B": motion(*end(g.but(dec=-g.dec)))["a_B"]},
        "no_coriolis": sliding_rod.without(*end(g), "coriolis"),
        "no_centripetal": sliding_rod.without(*end(g), "centripetal"),
        "no_a_rel": sliding_rod.without(*end(g), "relative"),
    }
