"""2/34: the lower tip of a bracket sliding on a turning plate."""

from exercises.devices import welder
from exercises.devices.turning_plate import acceleration_from

tip, solve, steps, prove, draw, mistakes = welder.about("E", -1)
follows = {"a_E": lambda g, v_E: acceleration_from(*tip(g), v_E)}
