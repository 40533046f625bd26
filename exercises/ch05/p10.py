"""5/10: the centre of mass of a figure of wire."""

from exercises.devices.put_together import centre, problem_of, unweighed, walked
from exercises.devices.wire_figure import WIRE, draw, parts, path
from newton_euler.bodies import Body, half_disk

solve, steps = problem_of(WIRE, parts, content="length", length="mm", given=("leg",))


def prove(g):
    return walked(*path(g))


def mistakes(g):
    half, diameter, leg = parts(g)
    sheet = half_disk(g.r, WIRE, "z", "y", density=1)
    return {
        "half_disk": centre(WIRE, [Body("half", half.mass, sheet.centre), diameter, leg]),
        "no_diameter": centre(WIRE, [half, leg]),
        "not_weighed": unweighed(WIRE, g.one, [part.centre for part in parts(g)]),
    }
