"""7/9: the inertia matrix of an L-shaped block with a bore."""

from exercises.devices.bored_bracket import BRACKET, block, draw, parts
from exercises.devices.inertia import no_products, problem_of, together, whole
from exercises.devices.inertia_proof import added, of_points
from exercises.tools import mp, proofs

solve, steps = problem_of(BRACKET, lambda g: parts(g, g.rho), "slug", "in", "slug*in^2", holes=True)


def prove(g):
    def solid(x, z, middle):
        points = proofs.box(x, g.l_y, z, order=2)
        return of_points(g.rho * x * g.l_y * z, points, [x / 2, g.l_y / 2, middle])

    base, wall = solid(g.l_x, g.h_b, g.h_b / 2), solid(g.t_w, g.h_w, g.h_b + g.h_w / 2)
    bore, volume = proofs.raised(proofs.disk(g.r_h, order=2), g.h_b), mp.pi * g.r_h**2 * g.h_b
    hole = of_points(g.rho * volume, bore, [g.x_h, g.l_y / 2, g.h_b / 2])
    I = added((1, base), (1, wall), (-1, hole))
    return {"I_O": I, "I_base": base, "I_wall": wall, "I_hole": hole}


def mistakes(g):
    (base, wall), holes = parts(g, g.rho)

    def with_wall(low, high):
        return whole(BRACKET, [base, block(g, "wall", g.t_w, low, high, g.rho)], holes)

    return {
        "no_products": no_products(BRACKET, together(BRACKET, [base, wall], holes)),
        "hole_added": whole(BRACKET, [base, wall, *holes]),
        "wall_from_its_foot": with_wall(0, g.h_w),
        "corner_twice": with_wall(0, g.h_b + g.h_w),
    }
