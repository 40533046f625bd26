"""7/12: the inertia matrix of a disk with an eccentric hole."""

from exercises.devices.disk_with_hole import DISK, draw, parts, rim
from exercises.devices.inertia import matrix, problem_of, together, untransferred, whole
from exercises.devices.inertia_proof import added, of_points, turned
from exercises.tools import mp, proofs

solve, steps = problem_of(
    DISK, lambda g: parts(g, g.rho), "kg", "m", "kg*m^2", holes=True, at_O=["full disk"]
)


def prove(g):
    """In polar coordinates about the centre of the hole, from its rim to that of the disk."""

    def ray(toward):
        c, s, _ = toward
        way = rim(g, c, s) - g.r
        spread = [(share, g.r + way / 2 + x) for share, (x, _, _) in proofs.box(way, 0, 0, order=2)]
        return added(*((u * way * r, turned([g.e + r * c, r * s, 0])) for u, r in spread))

    I = added((2 * mp.pi * g.rho, proofs.mean(ray, proofs.ring(1, order=40))))
    hole = of_points(g.rho * mp.pi * g.r**2, proofs.disk(g.r, order=2), [g.e, 0, 0])
    return {"I_O": I, "I_hole": hole, "I_full": added((1, I), (1, hole))}


def mistakes(g):
    (full,), (hole,) = parts(g, g.rho)
    xx, yy, zz = together(DISK, [full], [hole]).moments
    transfer = hole.about(DISK).terms["transfer"].moments[1]
    return {
        "no_offset": whole(DISK, [full], [untransferred(DISK, hole)]),
        "along_x_too": matrix(DISK, (xx - transfer, yy, zz)),
        "hole_added": whole(DISK, [full, hole]),
    }
