"""5/5: the centre of mass of a plate with six holes."""

from exercises.devices.put_together import centre, chord, sliced, sums
from exercises.steps import Step
from newton_euler import Frame
from newton_euler.bodies import disk, plate
from newton_euler.drawing import Sketch

PLATE = Frame("plate")


def places(g):
    return [(x, y) for y in (g.y1, g.y2) for x in (g.x1, g.x2, g.x3)]


def parts(g):
    full = plate(g.a, g.b, PLATE.point("middle", g.a / 2, g.b / 2, 0), "z", density=1)
    holes = [disk(g.r, PLATE.point("hole", x, y, 0), "z", density=1) for x, y in places(g)]
    return [full], holes


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


def draw(g, ax):
    s = Sketch(ax, PLATE, plane="xy")
    O, A, B, C = (0, 0, 0), (g.a, 0, 0), (0, g.b, 0), (g.a, g.b, 0)
    rims = [s.around((x, y, 0), (x + g.r, y, 0), PLATE.k) for x, y in places(g)]
    s.axes(O, PLATE, length=1.2 * g.a, labels=["x", "y", ""])
    s.plate([O, A, C, B], rims)
    s.label(O, "O")
    s.dimension(B, C, label="a")
    s.dimension(A, C, label="b")
    for n, (x, name) in enumerate(((g.x1, "$x_1$"), (g.x2, "$x_2$"), (g.x3, "$x_3$"))):
        s.dimension(O, (x, 0, 0), label=name, offset=-0.11 * g.a * (n + 1))
        s.line((x, 0, 0), (x, g.y2, 0), style="centre")
    for n, (y, name) in enumerate(((g.y1, "$y_1$"), (g.y2, "$y_2$"))):
        s.dimension(O, (0, y, 0), label=name, offset=0.11 * g.a * (n + 1))
        s.line((0, y, 0), (g.x3, y, 0), style="centre")
    s.dimension((g.x3, g.y2, 0), (g.x3 + 0.8 * g.r, g.y2 + 0.6 * g.r, 0), label="r", offset=0)
