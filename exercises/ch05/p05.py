"""5/5: the centre of mass of a plate with six holes."""

from exercises.devices.plate_with_holes import PLATE, draw, parts
from exercises.devices.put_together import centre, chord, sliced, sums
from newton_euler.bodies import composite


def solve(g):
    return centre(PLATE, *parts(g))


def steps(g):
    (full,), holes = parts(g)
    together = composite("six holes", holes)
    yield "A_full", full.mass
    yield "d_full", full.centre.position(PLATE)
    yield "A_hole", holes[0].mass
    yield "d_holes", together.centre.position(PLATE)
    yield from sums(PLATE, [full], [together], content="area", length="mm")


def prove(g):
    columns = (g.x1, g.x2, g.x3)
    cut = lambda x: sum(chord(x - column, g.r) for column in columns)
    slice_at = lambda x: (g.b - 2 * cut(x), g.b**2 / 2 - cut(x) * g.y1 - cut(x) * g.y2, 0)
    breaks = [column + side * g.r for column in columns for side in (-1, 1)]
    return sliced("area", slice_at, 0, g.a, breaks)


def mistakes(g):
    (full,), holes = parts(g)
    return {
        "holes_added": centre(PLATE, [full, *holes]),
        "full_mass": {"d": solve(g)["d"] * ((full.mass - 6 * holes[0].mass) / full.mass)},
        "diameter": solve(g.but(r=2 * g.r)),
    }
