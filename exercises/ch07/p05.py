"""7/5: the inertia matrix of a plate with six holes."""

from exercises.devices.inertia import no_products, together, untransferred, whole, wrong_sign
from exercises.devices.inertia_proof import added, of_points
from exercises.devices.plate_with_holes import PLATE, draw, parts, places
from exercises.tools import mp, proofs


def solve(g):
    return whole(PLATE, *parts(g, g.sigma))


def steps(g):
    (full,), holes = parts(g, g.sigma)
    own = together(PLATE, [untransferred(PLATE, hole) for hole in holes])
    return {
        "m_full": full.mass,
        "I_full": full.about(PLATE).matrix,
        "m_hole": holes[0].mass,
        "I_own": own.matrix,
        "I_holes": together(PLATE, holes).matrix,
    }


def prove(g):
    full = of_points(g.sigma * g.a * g.b, proofs.box(g.a, g.b, 0, order=2), [g.a / 2, g.b / 2, 0])
    mass = g.sigma * mp.pi * g.r**2
    rim = proofs.disk(g.r, order=2)
    holes = added(*((mass, of_points(1, rim, [x, y, 0])) for x, y in places(g)))
    return {"I_O": added((1, full), (-1, holes)), "I_full": full, "I_holes": holes}


def mistakes(g):
    (full,), holes = parts(g, g.sigma)
    I = together(PLATE, [full], holes)
    in_place = [untransferred(PLATE, hole) for hole in holes]
    return {
        "holes_not_transferred": whole(PLATE, [full], in_place),
        "holes_added": whole(PLATE, [full, *holes]),
        "no_product": no_products(PLATE, I),
        "plus_sign": wrong_sign(PLATE, I),
    }
