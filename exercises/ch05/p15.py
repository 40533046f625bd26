"""5/15: the centre of mass of four particles on light rods."""

from exercises.devices.four_particles import draw, masses, particles, rods
from exercises.tools import rate, root
from newton_euler import centre_of_mass


def centre(ground, parts):
    return {"d": centre_of_mass(parts, ground).position(ground)}


def solve(g):
    return centre(*particles(g))


def steps(g):
    ground, parts = particles(g)
    r = {f"r_{P.name[-1]}": P.position(ground) for _, P in parts[1:]}
    first = sum(m * place for (m, _), place in zip(parts[1:], r.values(), strict=True))
    return {"m": sum(m for m, _ in parts), **r, "Q": first}


def prove(g):
    """By zero moment of the weights about a knife edge across each axis in turn."""

    def balance(places):
        moment = lambda edge: sum(m * (x - edge) for m, x in zip(masses(g), places, strict=True))
        return root(moment, -max(places), 2 * max(places))

    axes = (0, g.a, g.a, g.a), (0, 0, g.b, g.b), (0, 0, 0, g.c)
    # Q is d/dt of half the sum of m (r + t e)^2, for each axis e
    half_square = lambda m, x: lambda t: m * (x + t) ** 2 / 2
    moment = lambda along: sum(map(rate, map(half_square, masses(g), along)))
    return {"d": [*map(balance, axes)], "Q": [*map(moment, axes)], "r_4": [g.a, g.b, g.c]}


def mistakes(g):
    ground, parts = particles(g)
    pairs = zip(parts[1:], rods(g), strict=True)
    from_before = [(m, ground.point("P", *rod)) for (m, _), rod in pairs]
    return {
        "no_masses": solve(g.but(m2=g.m1, m3=g.m1, m4=g.m1)),
        "without_the_first": centre(ground, parts[1:]),
        "from_the_one_before": centre(ground, [parts[0], *from_before]),
    }
