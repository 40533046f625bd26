"""10/11: two disks on a rod that do not precess."""

from exercises.devices.wobbling import neutral_length
from exercises.tools import Sketch, proofs
from newton_euler import Frame, composite, particle, solve_linear, sqrt
from newton_euler.bodies import disk


def assembly(g, b, part=None):
    """Two disks at the distance b, O in the middle; ``part(centre, name)`` makes other bodies."""
    frame = Frame("assembly")
    part = part or (lambda centre, name: disk(g.r, centre, "z", mass=g.m, name=name))
    ends = [(name, frame.point(name, 0, 0, z)) for name, z in (("P", -b / 2), ("Q", b / 2))]
    body = composite("assembly", [part(end, f"disk {name}") for name, end in ends])
    return body, frame.point("O", 0, 0, 0)


def length(g, across, axial):
    """The length at which the transverse moment, quadratic in it, equals the axial one."""
    flat, apart = across(0 * g.r), across(g.r)
    share = solve_linear(lambda square: flat + (apart - flat) * square - axial).square
    return {"b": g.r * sqrt(share)}


def axial(g):
    body, O = assembly(g, g.r)
    return body.about(O).moment("z")


def across(g, b):
    body, O = assembly(g, b)
    return body.about(O).moment("x")


def solve(g):
    return length(g, lambda b: across(g, b), axial(g))


def steps(g):
    return {"I": axial(g), "I_flat": across(g, 0 * g.r)}


def prove(g):
    """The length at which the mass points turn about a slanting axis without a moment."""
    flat = proofs.disk(g.r, order=2)
    points = lambda b: [(u / 2, [x, y, z]) for u, (x, y, _) in flat for z in (-b / 2, b / 2)]
    squares = lambda p: [p[0] ** 2 + p[1] ** 2, p[0] ** 2]
    I, I_flat = (2 * g.m * x for x in proofs.mean(squares, flat))
    return {"b": neutral_length(points, g.r), "I": I, "I_flat": I_flat}


def mistakes(g):
    def as_particles(b):
        body, O = assembly(g, b, lambda centre, name: particle(g.m, centre, name))
        return body.about(O).moment("x")

    def about_one_end(b):
        body, _ = assembly(g, b)
        return body.about(body.frame.point("P", 0, 0, b / 2)).moment("x")

    I = axial(g)
    return {
        "from_the_middle": length(g, lambda b: across(g, 2 * b), I),
        "particles": length(g, as_particles, I),
        "about_one_end": length(g, about_one_end, I),
    }


def draw(g, ax):
    ground = Frame("ground")
    s = Sketch(ax, ground, azimuth=-55, elevation=20)
    r, b = 1.0, 3.0  # not of the asked shape
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
