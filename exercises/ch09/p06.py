"""9/6: a plate that turns about its diagonal."""

from exercises.devices import rotor
from exercises.tools import box, mp
from newton_euler import atan2, bodies


def fixed_plate(g):
    return with_sides(g, g.a, g.b)


def with_sides(g, a, b):
    """The plate, x along PQ and y along PS, with moments of inertia for the sides a, b."""
    _, shaft = rotor.turning_shaft(g)
    edges = shaft.rotate("plate", "-z", angle=atan2(g.b, g.a))
    return rotor.in_bearings(shaft, [bodies.plate(a, b, edges, "z", mass=g.m)], -g.c, g.c)


solve, steps, follows = rotor.problem_of(
    fixed_plate,
    ("I_1", "x", "about the mid-line parallel to PQ"),
    ("I_2", "y", "about the mid-line parallel to PS"),
)


def prove(g):
    """Mass points at u PQ + v PS, where PQ + PS = PR."""
    PR = mp.hypot(g.a, g.b)
    PQ = [g.a**2 / PR, -g.a * g.b / PR]  # foot and height over the diagonal
    PS = [g.b**2 / PR, g.a * g.b / PR]
    shares = [(share * g.m, u, v) for share, (u, v, _) in box(1, 1, 0)]
    points = [(m, [u * PQ[0] + v * PS[0], u * PQ[1] + v * PS[1], 0]) for m, u, v in shares]
    return rotor.prove(g, points, -g.c, g.c) | {
        "I_1": sum(m * (v * g.b) ** 2 for m, _, v in shares),
        "I_2": sum(m * (u * g.a) ** 2 for m, u, _ in shares),
    }


def mistakes(g):
    r = fixed_plate(g)
    return {
        "principal_diagonal": {**rotor.with_inertia(r, product=0), "balance": "both"},
        "wrong_sign": rotor.with_inertia(r, product=-1),
        "mid_lines_exchanged": rotor.only(rotor.answers(with_sides(g, g.b, g.a))),
        "millimetres": rotor.with_inertia(r, moment=10**6, product=10**6),
    }


def draw(g, ax):
    r = fixed_plate(g)
    s = rotor.sketch(ax, r, azimuth=-20, elevation=12)
    a, b = g.a / 2, g.b / 2
    corners = [
        r.body.parts[0].frame.point(name, x, y, 0)
        for name, x, y in (("P", -a, -b), ("Q", a, -b), ("R", a, b), ("S", -a, b))
    ]
    P, Q, _, S = corners
    s.plate(corners)
    for corner in corners:
        s.label(corner, corner.name)
    s.axes(r.O, r.shaft, length=0.7 * b)
    s.label(r.O, "O")
    s.dimension(P, Q, label="a")
    s.dimension(P, S, label="b")
    s.dimension(r.O, r.B, label="c", offset=1.4 * b)
