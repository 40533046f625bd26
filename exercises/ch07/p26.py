"""7/26: a ring and a half ring about a tangent."""

from exercises.devices import half_ring as device
from exercises.tools import Sketch, mean
from exercises.tools import ring as points_of_ring
from newton_euler import bodies, pi


def full(g):
    return bodies.ring(g.r, device.RING, "z", mass=g.m)


def solve(g):
    part, M = device.half(g)
    return {"I_ring": full(g).about(M).moment("x"), "I_half": part.about(M).moment("x")}


def steps(g):
    yield "I_diameter", full(g).inertia.moment("x")
    about = "the parallel to the tangent through the centre of mass of the half ring"
    yield from device.half_steps(g, "x", about)


def prove(g):
    """The squares of the heights above the tangent, integrated along the wire."""
    down = device.mean_over_half(lambda x, y: -y, g.r)
    return {
        "I_ring": g.m * mean(lambda p: (p[1] + g.r) ** 2, points_of_ring(g.r)),
        "I_half": g.m * device.mean_over_half(lambda x, y: (y + g.r) ** 2, g.r),
        "d": down,
        "own": g.m * device.mean_over_half(lambda x, y: (y + down) ** 2, g.r),
    }


def mistakes(g):
    right = solve(g)["I_ring"]
    part, _ = device.half(g)
    d, I_x, I_z = device.depth(part), full(g).inertia.moment("x"), full(g).inertia.moment("z")
    half = device.from_G(g, I_z - g.m * d**2, d)
    return {
        "one_step": {"I_half": right},
        "halved": {"I_half": right / 2},
        "normal_axis": {"I_ring": I_z + g.m * g.r**2, "I_half": half},
        "half_disk": {"I_half": device.with_half_disk(g, I_x)},
    }


def draw(g, ax):
    s = Sketch(ax, device.RING, plane="xy")
    left, right = (-1.4 * g.r, 0, 0), (1.4 * g.r, 0, 0)
    circle = s.around(left, (-0.4 * g.r, 0, 0), device.RING.k)
    s.wire([*circle, *circle[:2]])
    s.wire(s.around(right, (0.4 * g.r, 0, 0), device.RING.k, pi(g.r)))
    s.line((0.4 * g.r, 0, 0), (2.4 * g.r, 0, 0))
    s.line((-2.8 * g.r, -g.r, 0), (2.8 * g.r, -g.r, 0), style="centre")
    s.arrow((2.8 * g.r, -g.r, 0), (3.2 * g.r, -g.r, 0), "x")
    for C in (left, right):
        s.dot(C)
        s.arrow(C, (C[0] + 0.8 * g.r, -0.6 * g.r, 0), "r")
