"""5/5: the centre of mass of a plate with six holes."""

from exercises.devices.plate_with_holes import PLATE, figure, parts
from exercises.devices.put_together import centre, chord, sliced, sums
from exercises.tools import Step

draw = figure


def solve(g):
    return centre(PLATE, *parts(g))


def steps(g):
    (full,), holes = parts(g)
    together = centre(PLATE, holes)["d"]
    yield Step("A_full", full.mass, "mm^2", "area of the plate before the holes are cut", "5.4")
    yield Step("d_full", full.centre.position(PLATE), "mm", "its centre", "5.4", "5.13")
    yield Step("A_hole", holes[0].mass, "mm^2", "area of one hole", "5.4")
    yield Step("d_holes", together, "mm", "centre of the six holes together, the mean of theirs",
               "5.4", "5.11")  # fmt: skip
    yield from sums(PLATE, [full], holes, content="area", length="mm")


def prove(g):
    columns = (g.x1, g.x2, g.x3)

    def slice_at(x):
        cut = sum(chord(x - column, g.r) for column in columns)
        return g.b - 2 * cut, g.b**2 / 2 - cut * g.y1 - cut * g.y2, 0

    breaks = [column + side * g.r for column in columns for side in (-1, 1)]
    return sliced("area", slice_at, 0, g.a, breaks)


def mistakes(g):
    (full,), holes = parts(g)
    left = full.mass - 6 * holes[0].mass
    return {
        "holes_added": centre(PLATE, [full, *holes]),
        "full_mass": {"d": solve(g)["d"] * (left / full.mass)},
        "diameter": solve(g.but(r=2 * g.r)),
    }
