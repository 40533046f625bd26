"""8/14: a figure of wire that turns about the axis of symmetry of its half circle."""

from exercises.devices import turning_body, wire_figure
from exercises.devices.turning_body import about_origin, answers, inertia_steps
from exercises.devices.wire_figure import WIRE, parts

AXIS = "y"


def inertia(g):
    return about_origin(WIRE, parts(g, g.rho))


solve, _, follows = turning_body.problem_of(inertia, AXIS)


def steps(g):
    yield from inertia_steps(inertia(g), AXIS)


def prove(g):
    pieces = turning_body.of_wire(g.rho, *wire_figure.path(g), ("leg", "diameter", "half"))
    found = turning_body.prove(g, AXIS, **pieces)
    del found["M_O_relative"], found["M_O_rotation"]  # the latter is zero: y is principal at O
    return found


def mistakes(g):
    I = inertia(g)
    half, leg = I.terms["half circle"], I.terms["leg"]
    (_, about_y, about_z), (_, _, zx) = half.moments, leg.products
    near = turning_body.added_to_moment(I, AXIS, -leg.mass * g.r**2)
    round_z = turning_body.added_to_moment(I, AXIS, about_z - about_y)
    return {
        "no_distance": answers(g, near, AXIS),
        "about_z": answers(g, round_z, AXIS),
        "product_with_y": answers(g, turning_body.other_products(I, xy=zx), AXIS),
        "millimetres": solve(g.but(r=1000 * g.r, c=1000 * g.c)),
    }


def draw(g, ax):
    wire_figure.draw(g, ax).turn((0, 1.35 * g.r, 0), WIRE.j, r"$\omega,\ \alpha$")
