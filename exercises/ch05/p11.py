"""5/11: the centre of mass of three rods end to end."""

from itertools import pairwise

from exercises.devices.chain_of_rods import CHAIN, all_from_O, corners, draw, path, rods
from exercises.devices.put_together import centre, sums, unweighed, walked


def solve(g):
    return centre(CHAIN, rods(pairwise(corners(g))))


def steps(g):
    parts = rods(pairwise(corners(g)))
    for part in parts:
        yield f"d_{part.name}", part.centre.position(CHAIN)
    yield from sums(CHAIN, parts, content="length", length="m", equal_parts=True)


def prove(g):
    return walked(*path(g))


def mistakes(g):
    return {
        "all_from_O": centre(CHAIN, rods(all_from_O(g))),
        "corners": unweighed(CHAIN, g.one, corners(g)),
        "not_divided": {"d": 3 * solve(g)["d"]},
    }
