"""7/11: the inertia matrix of three rods end to end."""

from itertools import pairwise

from exercises.devices.chain_of_rods import CHAIN, all_from_O, corners, figure, path, rods
from exercises.devices.inertia import added, along_path, answer, together, wrong_sign
from exercises.tools import Step
from newton_euler.bodies import particle

draw = figure


def parts(g):
    return rods(pairwise(corners(g)), mass=g.m)


def solve(g):
    return answer(together(CHAIN, parts(g)))


def steps(g):
    for rod in parts(g):
        name = rod.name
        yield Step(f"d_{name}", rod.centre.position(CHAIN), "m", f"middle of the rod {name}", "7.8")
        yield Step(f"I_G_{name}", rod.inertia.matrix, "kg*m^2",
                   f"inertia matrix of the rod {name} about its middle", "7.10")  # fmt: skip
        yield Step(f"I_{name}", rod.about(CHAIN).matrix, "kg*m^2",
                   f"inertia matrix of the rod {name} at O", "7.8", "7.25")  # fmt: skip


def prove(g):
    rods = along_path(g.m / g.a, *path(g))
    I = added(*((1, rod) for rod in rods))
    return {"I_O": I, **dict(zip(("I_OA", "I_AB", "I_BC"), rods, strict=True))}


def mistakes(g):
    return {
        "all_from_O": answer(together(CHAIN, rods(all_from_O(g), mass=g.m))),
        "at_the_middles": answer(
            together(CHAIN, [particle(g.m, part.centre) for part in parts(g)])
        ),
        "plus_sign": wrong_sign(CHAIN, together(CHAIN, parts(g))),
    }
