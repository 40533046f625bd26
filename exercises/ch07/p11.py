"""7/11: the inertia matrix of three rods end to end."""

from itertools import pairwise

from exercises.devices.chain_of_rods import CHAIN, all_from_O, corners, draw, path, rods
from exercises.devices.inertia import together, whole, wrong_sign
from exercises.devices.inertia_proof import added, along_path
from newton_euler.bodies import particle


def parts(g):
    return rods(pairwise(corners(g)), mass=g.m)


def solve(g):
    return whole(CHAIN, parts(g))


def steps(g):
    for rod in parts(g):
        yield f"d_{rod.name}", rod.centre.position(CHAIN)
        yield f"I_G_{rod.name}", rod.inertia.matrix
        yield f"I_{rod.name}", rod.about(CHAIN).matrix


def prove(g):
    rods = along_path(g.m / g.a, *path(g))
    I = added(*((1, rod) for rod in rods))
    return {"I_O": I, **dict(zip(("I_OA", "I_AB", "I_BC"), rods, strict=True))}


def mistakes(g):
    return {
        "all_from_O": whole(CHAIN, rods(all_from_O(g), mass=g.m)),
        "at_the_middles": whole(CHAIN, [particle(g.m, part.centre) for part in parts(g)]),
        "plus_sign": wrong_sign(CHAIN, together(CHAIN, parts(g))),
    }
