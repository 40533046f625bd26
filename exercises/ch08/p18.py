"""8/18: a quarter disk turning about one of its straight edges."""

from exercises.devices import turning_body
from exercises.tools import Sketch, mp, proofs
from newton_euler import Frame, bodies, pi

PLATE = Frame("plate")
AXIS = "x"


def inertia(g):
    """The inertia of a sector about its line of symmetry, turned to the axes."""
    symmetric = PLATE.rotate("symmetric", "z", angle=pi(g.one) / 4)
    quarter = bodies.sector(g.r, pi(g.one) / 4, symmetric, "z", "x", mass=g.m, name="plate")
    return quarter.about(PLATE.origin, PLATE)


solve, steps, follows = turning_body.problem_of(inertia, AXIS)


def prove(g):
    """By mass points along radii, integrated over the angle."""
    radii = proofs.box(1, 0, 0, order=2)

    def over_plate(f):
        def on_radius(phi):
            rho = lambda place: g.r * (place[0] + g.one / 2)
            weighed = lambda place: proofs.scaled(rho(place), f(proofs.at_angle(rho(place), phi)))
            return proofs.mean(weighed, radii)

        total = proofs.integral(on_radius, 0, mp.pi / 2)
        return proofs.scaled(4 * g.m / (mp.pi * g.r), total)

    return turning_body.prove(g, AXIS, plate=over_plate)


def mistakes(g):
    I = inertia(g)
    quartered = turning_body.added_to_moment(I, AXIS, -3 * I.moments[0] / 4)
    return {
        "no_products": turning_body.answers(g, turning_body.without_products(I), AXIS),
        "no_rotation": turning_body.no_rotation(g, I, AXIS),
        "quartered": turning_body.answers(g, quartered, AXIS),
        "wrong_sign": turning_body.answers(g, turning_body.wrong_sign(I), AXIS),
    }


def draw(g, ax):
    s = Sketch(ax, PLATE, azimuth=-60, elevation=28)
    O, X = (0, 0, 0), (g.r, 0, 0)
    s.plate([O, *s.around(O, X, PLATE.k, 3.14159265 / 2)])
    s.axes(O, PLATE, length=1.4 * g.r)
    s.turn((1.12 * g.r, 0, 0), PLATE.i, r"$\omega,\ \alpha$")
    s.dimension(O, X, "r")
    s.label(O, "O")
