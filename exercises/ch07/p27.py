"""7/27: a half ring about its diameter and about an axis through the middle of its arc."""

from exercises.devices.half_ring import RING, half, half_steps, mean_over_half, with_half_disk
from exercises.tools import Sketch
from newton_euler import pi


def solve(g):
    part, M = half(g)
    return {"I_AA": part.about(RING).moment("x"), "I_BB": part.about(M).moment("z")}


def steps(g):
    part, _ = half(g)
    yield "I_O", part.about(RING).moment("z")
    yield from half_steps(g, "z", "the parallel to BB' through the centre of mass")


def prove(g):
    """The squares of the distances from each axis, integrated along the wire."""
    down = mean_over_half(lambda x, y: -y, g.r)
    return {
        "I_AA": g.m * mean_over_half(lambda x, y: y**2, g.r),
        "I_BB": g.m * mean_over_half(lambda x, y: x**2 + (y + g.r) ** 2, g.r),
        "d": down,
        "own": g.m * mean_over_half(lambda x, y: x**2 + (y + down) ** 2, g.r),
    }


def mistakes(g):
    right = solve(g)
    part, _ = half(g)
    I_O = part.about(RING).moment("z")
    return {
        "one_step": {"I_BB": I_O + g.m * g.r**2},
        "halved": {key: x / 2 for key, x in right.items()},
        "half_disk": {"I_BB": with_half_disk(g, I_O)},
        "normal_axis": {"I_AA": I_O},
    }


def draw(g, ax):
    s = Sketch(ax, RING, azimuth=-30, elevation=25, up="y")
    s.wire(s.around((0, 0, 0), (-g.r, 0, 0), RING.k, pi(g.r)))
    s.dot((0, 0, 0))
    s.dot((0, -g.r, 0))
    s.arrow((0, 0, 0), (0.6 * g.r, -0.8 * g.r, 0), "r")
    A, B = (-1.4 * g.r, 0, 0), (0, -g.r, 0.8 * g.r)
    for name, start, end in ("A", A, (1.4 * g.r, 0, 0)), ("B", B, (0, -g.r, -0.8 * g.r)):
        s.line(start, end, style="centre")
        s.label(start, name, offset=(0, 10))
        s.label(end, f"{name}'", offset=(0, 10))
