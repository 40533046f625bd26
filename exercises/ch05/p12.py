"""5/12: the centre of mass of a disk with a hole beside its centre."""

from mpmath import mp

from exercises import proofs
from exercises.devices.put_together import centre, proved, steps_of
from newton_euler import Frame
from newton_euler.bodies import disk
from newton_euler.drawing import Sketch

DISK = Frame("disk")


def parts(g):
    full = disk(g.R, DISK, "z", density=1, name="full disk")
    return [full], [disk(g.r, DISK.point("C", g.e, 0, 0), "z", density=1, name="hole")]


def solve(g):
    return centre(DISK, *parts(g))


def steps(g):
    yield from steps_of(DISK, *parts(g), content="area", length="m")


def prove(g):
    """In polar coordinates about the centre of the hole, from its rim to that of the disk."""

    def ray(angle):
        c, s = mp.cos(angle), mp.sin(angle)
        end = mp.sqrt(g.R**2 - (g.e * s) ** 2) - g.e * c
        area, first = (end**2 - g.r**2) / 2, (end**3 - g.r**3) / 3
        return [area, g.e * area + c * first, s * first]

    whole, *first = proofs.integral(ray, 0, 2 * mp.pi)
    return proved("area", whole, [*first, 0])


def mistakes(g):
    (full,), (hole,) = parts(g)
    d = solve(g)["d"]
    return {
        "hole_added": centre(DISK, [full, hole]),
        "full_area": {"d": d * ((full.mass - hole.mass) / full.mass)},
        "toward_the_hole": {"d": -d},
    }


def draw(g, ax):
    s = Sketch(ax, DISK, plane="xy")
    O, C = (0, 0, 0), (g.e, 0, 0)
    s.axes(O, DISK, length=1.3 * g.R, labels=["x", "y", ""])
    s.plate(s.around(O, (g.R, 0, 0), DISK.k), [s.around(C, (g.e + g.r, 0, 0), DISK.k)])
    s.dot(C)
    s.dimension(O, (-0.8 * g.R, 0.6 * g.R, 0), label="R", offset=0)
    s.dimension(C, (g.e + 0.6 * g.r, 0.8 * g.r, 0), label="r", offset=0)
    s.dimension(O, C, label="e", offset=-1.3 * g.r)
    s.label(O, "O")
