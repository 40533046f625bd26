"""10/11: two disks on a rod without precession."""

from exercises.devices.wobbling import neutral_length
from exercises.tools import on_ground, proofs
from newton_euler import Frame, sqrt
from newton_euler.bodies import disk


def in_the_middle(g):
    """The axial and transverse moments of inertia with both centres at O."""
    both = disk(g.r, Frame("rod").point("O", 0, 0, 0), "z", mass=2 * g.m)
    return both.inertia.moment("z"), both.inertia.moment("x")


def length(g, I, across, share=2):
    """The b at which ``across`` plus the transfer term m b^2/share equals the axial moment."""
    return {"b": sqrt(share * (I - across) / g.m)}


def solve(g):
    return length(g, *in_the_middle(g))


def steps(g):
    I, I_flat = in_the_middle(g)
    return {"I": I, "I_flat": I_flat}


def prove(g):
    """The length at which the mass points turn about a slanting axis without a moment."""
    flat = proofs.disk(g.r, order=2)
    points = lambda b: [(u / 2, [x, y, z]) for u, (x, y, _) in flat for z in (-b / 2, b / 2)]
    squares = lambda p: [p[0] ** 2 + p[1] ** 2, p[0] ** 2]
    I, I_flat = (2 * g.m * x for x in proofs.mean(squares, flat))
    return {"b": neutral_length(points, g.r), "I": I, "I_flat": I_flat}


def mistakes(g):
    I, I_flat = in_the_middle(g)
    return {
        "from_the_middle": length(g, I, I_flat, share=g.one / 2),
        "particles": length(g, I, 0),
        "about_one_end": length(g, I, I_flat, share=1),
    }


def draw(g, ax):
    ground, s = on_ground(ax, azimuth=-55, elevation=20)
    r, b = 1.0, 3.0  # not the shape asked for
    P, Q = (-b / 2, 0, 0), (b / 2, 0, 0)
    s.rod(P, Q)
    for end in (P, Q):
        s.disk(end, ground.i, r)
    s.line(Q, (b / 2 + 1.6 * r, 0, 0), style="centre")
    s.turn((b / 2 + r, 0, 0), ground.i, label="spin")
    s.dimension((-b / 2, 0, -r), (b / 2, 0, -r), label="b", offset=-0.3)
    s.dimension(Q, (b / 2, 0, r), label="r", offset=0)
    s.label((-b / 2, 0, r), "m", offset=(0, 9), bold=False)
    s.label((b / 2, 0, r), "m", offset=(0, 9), bold=False)
