"""5/14: the centre of mass of a bent plate with a hole and a round top."""

from exercises.devices.bent_plate import PART, draw, parts
from exercises.devices.put_together import centre, chord, problem_of, proved
from exercises.tools import proofs

solve, steps = problem_of(PART, parts, holes=True, content="mass", mass="kg", length="mm")


def prove(g):
    """The horizontal part by slices of constant x, the vertical one by slices of constant z."""

    def horizontal(x):
        width = g.w - chord(x - g.x_h, g.r_h)
        return [width, x * width, width * g.w / 2, 0]

    def vertical(z):
        width = g.w if z < g.h_v else chord(z - g.h_v, g.w / 2)
        return [width, 0, width * g.w / 2, z * width]

    area, *first = proofs.plus(
        proofs.integral(horizontal, 0, g.l_h, (g.x_h - g.r_h, g.x_h + g.r_h)),
        proofs.integral(vertical, 0, g.h_v + g.w / 2, (g.h_v,)),
    )
    return proved("mass", g.sigma * area, [g.sigma * m for m in first])


def mistakes(g):
    solid, holes = parts(g)
    return {
        "no_hole": centre(PART, solid),
        "hole_added": centre(PART, [*solid, *holes]),
        "top_from_its_edge": centre(PART, *parts(g, foot=0)),
        "w_as_radius": centre(PART, *parts(g, radius=g.w)),
    }
