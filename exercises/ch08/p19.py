"""8/19: four particles on light rods, turning about a line."""

from itertools import pairwise

from exercises.devices import turning_body
from exercises.devices.turning_body import about_origin, answers
from exercises.tools import Sketch
from newton_euler import Frame, particle

BODY = Frame("body")
AXIS = "x"
NAMES = "first", "second", "third", "fourth"
PLACES = (1, 1, 0), (2, 0, 1), (1, -1, 2), (1, 2, 1)  # in units of d


def masses(g):
    return g.m_1, g.m_2, g.m_3, g.m_4


def places(g):
    return [[n * g.d for n in place] for place in PLACES]


def inertia(g):
    return about_origin(BODY, [
        particle(m, BODY.point(name, *place), f"{name} body")
        for name, m, place in zip(NAMES, masses(g), places(g), strict=True)
    ])  # fmt: skip


solve, steps, follows = turning_body.problem_of(inertia, AXIS, particles=True)


def prove(g):
    pairs = zip(masses(g), places(g), strict=True)
    bodies = [turning_body.of_points(m, [(1, place)]) for m, place in pairs]
    return turning_body.prove(g, AXIS, **dict(zip(NAMES, bodies, strict=True)))


def mistakes(g):
    I = inertia(g)
    squares_of_x = sum(m * x**2 for m, (x, _, _) in zip(masses(g), places(g), strict=True))
    xy, _, zx = I.products
    unsigned = turning_body.other_products(I, xy=xy + 2 * g.m_3 * g.d**2)
    return {
        "no_rotation": turning_body.no_rotation(g, I, AXIS),
        "wrong_sign": answers(g, turning_body.wrong_sign(I), AXIS),
        "from_origin": answers(g, turning_body.added_to_moment(I, AXIS, squares_of_x), AXIS),
        "unsigned": answers(g, unsigned, AXIS),
        "exchanged": answers(g, turning_body.other_products(I, xy=zx, zx=xy), AXIS),
    }


def draw(g, ax):
    s = Sketch(ax, BODY, azimuth=25, elevation=22)
    O, d = (0, 0, 0), g.d
    points = places(g)
    s.axes(O, BODY, length=3.6 * d)
    s.shaft((-0.3 * d, 0, 0), (2.6 * d, 0, 0))
    for place in points:
        s.rod((place[0], 0, 0), place)
    for P, Q in pairwise(points):
        s.line(P, Q, style="solid")
    total = sum(masses(g))
    for n, (m, P) in enumerate(zip(masses(g), points, strict=True), 1):
        s.sphere(P, 0.16 * d * (4 * m / total) ** (1 / 3))  # all of one density
        s.label(P, f"$m_{n}$", bold=False)
    s.turn((3.2 * d, 0, 0), BODY.i, r"$\omega,\ \alpha$")
    s.dimension((2 * d, 0, 0), points[1], "d", offset=(0, -0.45 * d, 0))
    s.label(O, "O")
