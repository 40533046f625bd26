"""7/30: the moment of inertia of three rods about an axis through their centre of mass."""

from itertools import pairwise

from exercises.devices import chain_of_rods
from exercises.devices.chain_of_rods import CHAIN, corners, path, rods
from exercises.tools import proofs
from newton_euler import composite, particle


def parts(g):
    return rods(pairwise(corners(g)), mass=g.m)


def at_O_and_G(g):
    """The :class:`Inertia` of the assembly at O, and at its centre of mass."""
    body = composite("assembly", parts(g))
    at_O = body.about(CHAIN)
    return at_O, at_O.about(body.centre)


def solve(g):
    return {"I_xp": at_O_and_G(g)[1].moment("x")}


def steps(g):
    for part in parts(g):
        yield f"I_{part.name}", part.about(CHAIN).moment("x")
    yield "d", composite("assembly", parts(g)).centre.position(CHAIN)


def prove(g):
    """The squares of the distances from x', integrated along the chain."""
    place, way, bends = path(g)
    total = lambda f: proofs.integral(lambda s: f(place(s)), 0, way, bends)
    d = proofs.scaled(1 / way, total(lambda p: p))
    square = total(lambda p: (p[1] - d[1]) ** 2 + (p[2] - d[2]) ** 2) / way
    return {"I_xp": 3 * g.m * square, "d": d}


def mistakes(g):
    O, G = (I.moment("x") for I in at_O_and_G(g))
    balls = [particle(g.m, part.centre, part.name) for part in parts(g)]
    return {
        "one_mass": {"I_xp": O - (O - G) / 3},
        "adds_the_transfer": {"I_xp": 2 * O - G},
        "about_x": {"I_xp": O},
        "at_the_middles": {"I_xp": composite("balls", balls).inertia.moment("x")},
    }


def draw(g, ax):
    s = chain_of_rods.draw(g, ax)
    G = composite("assembly", parts(g)).centre
    x, y, z = G.position(CHAIN).components()
    s.dot(G, "G")
    s.line((x - 1.6 * g.a, y, z), (x + 0.9 * g.a, y, z), style="centre")
    s.arrow((x + 0.9 * g.a, y, z), (x + 1.2 * g.a, y, z), "$x'$")
