"""8/16: a right triangle that turns about one of its legs."""

from exercises.devices import turning_body
from exercises.tools import Sketch, proofs
from newton_euler import Frame, bodies

PLATE = Frame("plate")
AXIS = "z"


def corners(g):
    places = [(0, 0, 0), (g.b, 0, 0), (0, 0, g.h)]
    return [PLATE.point(name, *place) for name, place in zip("OAC", places, strict=True)]


def inertia(g):
    return turning_body.about_origin(PLATE, [bodies.simplex(*corners(g), mass=g.m)])


solve, steps, follows = turning_body.problem_of(inertia, AXIS, "US")


def prove(g):
    """By the mass points of a square, mapped to the triangle, with edges going to O and AC."""

    def over_plate(f):
        def weighed(place):
            u, v = place[0] + g.one / 2, place[1] + g.one / 2
            return proofs.scaled(2 * g.m * v, f([g.b * v * (1 - u), 0, g.h * v * u]))

        return proofs.mean(weighed, proofs.box(1, 1, 0))

    return turning_body.prove(g, AXIS, plate=over_plate)


def mistakes(g):
    I = inertia(g)
    at_centre = turning_body.other_products(I, zx=g.m * g.b * g.h / 9)
    return {
        "no_products": turning_body.answers(g, turning_body.without_products(I), AXIS),
        "no_rotation": turning_body.no_rotation(g, I, AXIS),
        "at_centre": turning_body.answers(g, at_centre, AXIS),
        "wrong_sign": turning_body.answers(g, turning_body.wrong_sign(I), AXIS),
    }


def draw(g, ax):
    s = Sketch(ax, PLATE, azimuth=55, elevation=20)
    O, A, C = corners(g)
    s.plate([O, A, C])
    s.axes(O, PLATE, length=1.45 * max(g.b, g.h))
    s.turn((0, 0, 1.15 * g.h), PLATE.k, r"$\omega,\ \alpha$")
    s.dimension(O, A, "b")
    s.dimension(O, C, "h")
    for P in (O, A, C):
        s.label(P, P.name)
