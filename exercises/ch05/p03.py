"""5/3: the centre of mass of a block with a cylinder on top."""

from exercises.devices.block_with_cylinder import BLOCK, draw, parts
from exercises.devices.put_together import centre, chord, problem_of, sliced, unweighed

solve, steps = problem_of(BLOCK, parts, content="volume", length="in")


def prove(g):
    def slice_at(x):
        block, above = g.b * g.c, chord(x - g.x_c, g.r_c) * g.l_c
        whole, top = block + above, g.c + g.l_c
        return whole, whole * g.b / 2, block * g.c / 2 + above * (g.c + top) / 2

    return sliced("volume", slice_at, 0, g.a, (g.x_c - g.r_c, g.x_c + g.r_c))


def mistakes(g):
    return {
        "not_weighed": unweighed(BLOCK, g.one, [part.centre for part in parts(g)]),
        "from_its_own_base": centre(BLOCK, parts(g, foot=0)),
        "r_c_as_diameter": solve(g.but(r_c=g.r_c / 2)),
    }
