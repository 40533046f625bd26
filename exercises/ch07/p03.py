"""7/3: the inertia matrix of a block with a cylinder on top."""

from exercises.devices.block_with_cylinder import BLOCK, draw, parts
from exercises.devices.inertia import answer, no_products, problem_of, together, whole, wrong_sign
from exercises.devices.inertia_proof import added, of_points
from exercises.tools import mp, proofs

solve, steps = problem_of(BLOCK, lambda g: parts(g, density=g.rho), "slug", "in", "slug*ft^2")


def prove(g):
    points = proofs.box(g.a, g.b, g.c, order=2)
    block = of_points(g.rho * g.a * g.b * g.c, points, [g.a / 2, g.b / 2, g.c / 2])
    points, mass = proofs.raised(proofs.disk(g.r_c, order=2), g.l_c), mp.pi * g.r_c**2 * g.l_c
    cylinder = of_points(g.rho * mass, points, [g.x_c, g.b / 2, g.c + g.l_c / 2])
    return {"I_O": added((1, block), (1, cylinder)), "I_block": block, "I_cylinder": cylinder}


def mistakes(g):
    I = together(BLOCK, parts(g, density=g.rho))
    return {
        "no_products": no_products(BLOCK, I),
        "plus_sign": wrong_sign(BLOCK, I),
        "from_its_own_base": whole(BLOCK, parts(g, foot=0, density=g.rho)),
        "rho_per_foot": answer(12**5 * I),
    }
