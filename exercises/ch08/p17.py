"""8/17: a chain of three rods that turns about a line through its end."""

from itertools import pairwise

from exercises.devices import chain_of_rods, turning_body
from exercises.devices.chain_of_rods import CHAIN, corners, rods
from exercises.devices.turning_body import about_origin, answers

AXIS = "x"


def inertia(g):
    return about_origin(CHAIN, rods(pairwise(corners(g, "z")), mass=g.m))


solve, steps, follows = turning_body.problem_of(inertia, AXIS)


def prove(g):
    pieces = turning_body.of_wire(g.m / g.a, *chain_of_rods.path(g, "z"), ("OA", "AB", "BC"))
    return turning_body.prove(g, AXIS, **pieces)


def mistakes(g):
    I = inertia(g)
    return {
        "no_rotation": turning_body.no_rotation(g, I, AXIS),
        "euler": {"M_O": answers(g, turning_body.without_products(I), AXIS)["M_O"]},
        "wrong_sign": answers(g, turning_body.wrong_sign(I), AXIS),
        "no_distance": answers(g, turning_body.added_to_moment(I, AXIS, -g.m * g.a**2), AXIS),
    }


def draw(g, ax):
    chain_of_rods.draw(g, ax, "z").turn((1.3 * g.a, 0, 0), CHAIN.i, r"$\omega,\ \alpha$")
