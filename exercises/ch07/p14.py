"""7/14: the inertia matrix of a bent plate with a hole and a round top."""

from exercises.devices.bent_plate import PART, draw, parts
from exercises.devices.inertia import no_products, problem_of, together, untransferred, whole
from exercises.devices.inertia_proof import added, of_points
from exercises.tools import mp, proofs
from newton_euler.bodies import Body

solve, steps = problem_of(PART, parts, "kg", "mm", "kg*m^2", holes=True)


def prove(g):
    """The rectangles and the hole by their mass points, the round top by strips along y."""
    radius = g.w / 2

    def strip(up):
        width = 2 * mp.sqrt(radius**2 - up**2)
        return of_points(width, proofs.box(0, width, 0, order=2), [0, radius, g.h_v + up])

    flat, upright = proofs.box(g.l_h, g.w, 0, order=2), proofs.box(0, g.w, g.h_v, order=2)
    horizontal = of_points(g.sigma * g.l_h * g.w, flat, [g.l_h / 2, radius, 0])
    vertical = of_points(g.sigma * g.w * g.h_v, upright, [0, radius, g.h_v / 2])
    top = added((g.sigma, proofs.integral(strip, 0, radius)))
    hole = of_points(g.sigma * mp.pi * g.r_h**2, proofs.disk(g.r_h, order=2), [g.x_h, radius, 0])
    return {
        "I_O": added((1, horizontal), (1, vertical), (1, top), (-1, hole)),
        "I_horizontal": horizontal,
        "I_vertical": vertical,
        "I_half": top,
        "I_hole": hole,
    }


def mistakes(g):
    (flat, upright, top), holes = parts(g)
    edge = PART.point("edge", 0, g.w / 2, g.h_v)
    in_place = [untransferred(PART, hole) for hole in holes]
    too_low = Body("half disk", top.mass, edge, top.inertia.moments, PART)
    return {
        "top_on_its_edge": whole(PART, [flat, upright, too_low], holes),
        "hole_not_transferred": whole(PART, [flat, upright, top], in_place),
        "no_products": no_products(PART, together(PART, *parts(g))),
        "w_as_radius": whole(PART, *parts(g, radius=g.w)),
    }
