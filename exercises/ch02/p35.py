"""2/35: the upper tip of a bracket sliding on a turning plate."""

from exercises.devices import welder
from exercises.devices.turning_plate import acceleration_from

tip, solve, steps, prove, draw, mistakes = welder.about("D", 1)
follows = {"a_D": lambda g, v_D: acceleration_from(*tip(g), v_D)}
