"""5/2: the centre of mass of two spheres that touch."""

from exercises.devices.put_together import centre, problem_of, proved
from exercises.devices.satellite import SATELLITE, draw, parts, spheres
from exercises.tools import proofs

GIVEN = "larger", "smaller"
solve, steps = problem_of(SATELLITE, parts, content="mass", mass="slug", length="ft", given=GIVEN)


def prove(g):
    """By the mass points of both spheres."""
    centres = [(m, proofs.plus(middle, proofs.mean(list, ball))) for m, ball, middle in spheres(g)]
    first = proofs.plus(*(proofs.scaled(m, place) for m, place in centres))
    return proved("mass", sum(m for m, _ in centres), first)


def mistakes(g):
    return {
        "by_volume": solve(g.but(m1=g.R1**3, m2=g.R2**3)),
        "R1_for_distance": centre(SATELLITE, parts(g, distance=g.R1)),
        "larger_mass_only": {"d": solve(g)["d"] * ((g.m1 + g.m2) / g.m1)},
    }
