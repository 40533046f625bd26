"""7/13: the inertia matrix of three welded rods of different lengths."""

from exercises.devices.inertia import (
    added,
    along_path,
    answer,
    no_products,
    steps_of,
    together,
    wrong_sign,
)
from exercises.devices.welded_rods import WELDED, figure, parts, path

draw = figure


def solve(g):
    return answer(together(WELDED, parts(g, density=g.rho)))


def steps(g):
    units = {"mass": "kg", "length": "m", "inertia": "kg*m^2"}
    yield from steps_of(WELDED, parts(g, density=g.rho), **units)


def prove(g):
    rods = along_path(g.rho, *path(g))
    I = added(*((1, rod) for rod in rods))
    return {"I_O": I, **dict(zip(("I_first", "I_second", "I_third"), rods, strict=True))}


def mistakes(g):
    I = together(WELDED, parts(g, density=g.rho))
    third = g.rho * (g.b + g.c + g.L) / 3
    return {
        "third_at_the_bottom": answer(together(WELDED, parts(g, height=0, density=g.rho))),
        "equal_masses": answer(together(WELDED, parts(g, mass=third))),
        "no_product": no_products(WELDED, I),
        "plus_sign": wrong_sign(WELDED, I),
    }
