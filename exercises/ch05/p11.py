"""5/11: the centre of mass of three rods end to end."""

from itertools import pairwise

from exercises.devices.put_together import centre, sums, unweighed, walked
from exercises.steps import Step
from newton_euler import Frame
from newton_euler.bodies import simplex
from newton_euler.drawing import Sketch

CHAIN = Frame("chain")


def corners(g):
    places = [(0, 0, 0), (g.a, 0, 0), (g.a, g.a, 0), (g.a, g.a, g.a)]
    return [CHAIN.point(name, *place) for name, place in zip("OABC", places, strict=True)]


def rods(pairs):
    return [simplex(P, Q, density=1, name=P.name + Q.name) for P, Q in pairs]


def solve(g):
    return centre(CHAIN, rods(pairwise(corners(g))))


def steps(g):
    parts = rods(pairwise(corners(g)))
    for part in parts:
        middle = part.centre.position(CHAIN)
        yield Step(f"d_{part.name}", middle, "m", f"middle of the rod {part.name}", "5.5")
    yield from sums(CHAIN, parts, content="length", length="m")


def prove(g):
    """Along the chain."""

    def path(s):
        return [min(max(s - n * g.a, 0), g.a) for n in range(3)]

    return walked(path, 3 * g.a, (g.a, 2 * g.a))


def mistakes(g):
    O, A, *_ = corners(g)
    ends = [A, CHAIN.point("B", 0, g.a, 0), CHAIN.point("C", 0, 0, g.a)]
    return {
        "all_from_O": centre(CHAIN, rods((O, end) for end in ends)),
        "corners": unweighed(CHAIN, g.one, corners(g)),
        "not_divided": {"d": 3 * solve(g)["d"]},
    }


def draw(g, ax):
    s = Sketch(ax, CHAIN, azimuth=-60, elevation=22)
    O, A, B, C = corners(g)
    s.axes(O, CHAIN, length=1.5 * g.a)
    for P, Q in pairwise((O, A, B, C)):
        s.rod(P, Q)
        s.dimension(P, Q, label="a")
    for P in (O, A, B, C):
        s.label(P, P.name)
