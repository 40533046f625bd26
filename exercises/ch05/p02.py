"""5/2: the centre of mass of two spheres that touch."""

from exercises.devices.put_together import centre, problem_of, proved
from exercises.devices.satellite import SATELLITE, figure, parts, spheres
from exercises.tools import proofs

solve, steps = problem_of(
    SATELLITE, parts, content="mass", mass="slug", length="ft", given=("larger", "smaller")
)
draw = figure


def prove(g):
    """By the mass points of both spheres."""
    points = [
        (mass * share, proofs.plus(place, middle))
        for mass, ball, middle in spheres(g)
        for share, place in ball
    ]
    whole = sum(m for m, _ in points)
    return proved("mass", whole, [sum(m * place[n] for m, place in points) for n in range(3)])


def mistakes(g):
    whole = g.m1 + g.m2
    return {
        "by_volume": solve(g.but(m1=g.R1**3, m2=g.R2**3)),
        "R1_for_distance": centre(SATELLITE, parts(g, distance=g.R1)),
        "larger_mass_only": {"d": solve(g)["d"] * (whole / g.m1)},
    }
