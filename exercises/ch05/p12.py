"""5/12: the centre of mass of a disk with an eccentric hole."""

from exercises.devices.disk_with_hole import DISK, draw, parts, rim
from exercises.devices.put_together import centre, problem_of, proved
from exercises.tools import mp, proofs

solve, steps = problem_of(DISK, parts, holes=True, content="area", length="m")


def prove(g):
    """In polar coordinates about the centre of the hole, from its rim to that of the disk."""

    def ray(toward):
        c, s, _ = toward
        end = rim(g, c, s)
        area, first = (end**2 - g.r**2) / 2, (end**3 - g.r**3) / 3
        return [area, g.e * area + c * first, s * first]

    whole, *first = proofs.scaled(2 * mp.pi, proofs.mean(ray, proofs.ring(1, order=40)))
    return proved("area", whole, [*first, 0])


def mistakes(g):
    (full,), (hole,) = parts(g)
    d = solve(g)["d"]
    return {
        "hole_added": centre(DISK, [full, hole]),
        "full_area": {"d": d * ((full.mass - hole.mass) / full.mass)},
        "toward_the_hole": {"d": -d},
    }
