"""7/11: the inertia matrix of three rods end to end."""

from itertools import pairwise

from exercises.devices import chain_of_rods
from exercises.devices.chain_of_rods import CHAIN, all_from_O, corners, path, rods
from exercises.devices.inertia import along_path, answer, steps_of, together, wrong_sign
from newton_euler.bodies import particle


def parts(g):
    return rods(pairwise(corners(g)), mass=g.m)


def solve(g):
    return answer(together(CHAIN, parts(g)))


def steps(g):
    for step in steps_of(CHAIN, parts(g), mass="kg", length="m", inertia="kg*m^2"):
        if not step.key.startswith("m_"):  # all the same, and given
            yield step


def prove(g):
    return {"I_O": along_path(g.m / g.a, *path(g))}


def mistakes(g):
    return {
        "all_from_O": answer(together(CHAIN, rods(all_from_O(g), mass=g.m))),
        "at_the_middles": answer(
            together(CHAIN, [particle(g.m, part.centre) for part in parts(g)])
        ),
        "plus_sign": wrong_sign(CHAIN, together(CHAIN, parts(g))),
    }


def draw(g, ax):
    chain_of_rods.figure(g, ax)
