"""8/11: the angular momentum of a chain of three rods that turns about a line through its end."""

from itertools import pairwise

from exercises.devices import chain_of_rods, turning_body
from exercises.devices.chain_of_rods import CHAIN, corners, rods
from exercises.devices.turning_body import about_origin, inertia_steps
from newton_euler.dynamics import fixed_line_momentum

AXIS = "z"


def inertia(g):
    return about_origin(CHAIN, rods(pairwise(corners(g, edge="b")), mass=g.m))


def momentum(g, inertia):
    return {"H_O": fixed_line_momentum(inertia, g.omega, AXIS)}


def solve(g):
    return momentum(g, inertia(g))


def steps(g):
    yield from inertia_steps(inertia(g), AXIS)


def prove(g):
    way = chain_of_rods.path(g, edge="b")
    pieces = turning_body.of_wire(g.m / g.b, *way, ("OA", "AB", "BC"))
    return turning_body.prove_momentum(g, AXIS, **pieces)


def mistakes(g):
    I = inertia(g)
    mbb = g.m * g.b**2
    less = lambda part: momentum(g, turning_body.added_to_moment(I, AXIS, -part * mbb))
    return {
        "no_products": momentum(g, turning_body.without_products(I)),
        "wrong_sign": momentum(g, turning_body.wrong_sign(I)),
        "no_distances": less(1 + 2),  # shares of AB and BC
        "about_middles": less(g.one / 3 + g.one / 3 - g.one / 12 - g.one / 12),  # of OA, AB
    }


def draw(g, ax):
    chain_of_rods.draw(g, ax, edge="b").turn((0, 0, 1.2 * g.b), CHAIN.k, r"$\omega$")
