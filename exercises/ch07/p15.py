"""7/15: the inertia matrix of four particles on light rods."""

from exercises.devices.four_particles import draw, masses, particles, places, rods
from exercises.devices.inertia import answer, matrix, together, wrong_sign
from exercises.tools import cross, plus, rate, rot, scaled, times, transposed
from newton_euler.bodies import particle


def inertia(ground, pairs):
    """The :class:`Inertia` at O of pairs (mass, point)."""
    return together(ground, [particle(m, P) for m, P in pairs])


def solve(g):
    return answer(inertia(*particles(g)))


def steps(g):
    ground, (_, *others) = particles(g)
    for m, P in others:
        yield f"r_{P.name[-1]}", P.position(ground)
        yield f"I_{P.name[-1]}", inertia(ground, [(m, P)]).matrix


def prove(g):
    """The columns are the angular momenta for unit rates about x, y and z."""

    def momentum(axis):
        v = lambda start: rate(lambda t: times(rot(axis, t), start))
        of_one = lambda m, start: scaled(m, cross(start, v(start)))
        return plus(*(of_one(m, list(at)) for m, at in zip(masses(g), places(g), strict=True)))

    return {"I_O": transposed([momentum(axis) for axis in "xyz"])}


def mistakes(g):
    ground, parts = particles(g)
    I = inertia(ground, parts)
    xx, yy, zz = I.moments
    half = (xx + yy + zz) / 2  # the sum of m (x^2 + y^2 + z^2)
    pairs = zip(parts[1:], rods(g), strict=True)
    from_before = [(m, ground.point("P", *rod)) for (m, _), rod in pairs]
    return {
        "squares_of_the_axis": matrix(ground, (half - xx, half - yy, half - zz), I.products),
        "from_the_one_before": answer(inertia(ground, [parts[0], *from_before])),
        "plus_sign": wrong_sign(ground, I),
    }
