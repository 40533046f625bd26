"""7/13: the inertia matrix of three welded rods of different lengths."""

from exercises.devices.inertia import no_products, problem_of, together, whole, wrong_sign
from exercises.devices.inertia_proof import added, along_path
from exercises.devices.welded_rods import WELDED, draw, parts, path

solve, steps = problem_of(WELDED, lambda g: parts(g, density=g.rho), "kg", "m", "kg*m^2")


def prove(g):
    rods = along_path(g.rho, *path(g))
    I = added(*((1, rod) for rod in rods))
    return {"I_O": I, **dict(zip(("I_first", "I_second", "I_third"), rods, strict=True))}


def mistakes(g):
    I = together(WELDED, parts(g, density=g.rho))
    return {
        "third_at_the_bottom": whole(WELDED, parts(g, height=0, density=g.rho)),
        "equal_masses": whole(WELDED, parts(g, mass=g.rho * (g.b + g.c + g.L) / 3)),
        "no_product": no_products(WELDED, I),
        "plus_sign": wrong_sign(WELDED, I),
    }
