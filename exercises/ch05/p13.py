"""5/13: the centre of mass of three welded rods of different lengths."""

from exercises.devices.put_together import centre, problem_of, unweighed, walked
from exercises.devices.welded_rods import WELDED, draw, parts, path

RODS = "first", "second", "third"
solve, steps = problem_of(WELDED, parts, content="length", length="m", given=RODS)


def prove(g):
    return walked(*path(g))


def mistakes(g):
    return {
        "equal_weights": unweighed(WELDED, g.one, [rod.centre for rod in parts(g)]),
        "third_at_the_bottom": centre(WELDED, parts(g, height=0)),
        "without_first_length": {"d": solve(g)["d"] * ((g.b + g.c + g.L) / (g.c + g.L))},
    }
