"""5/9: the centre of mass of an L-shaped block with a bore."""

from exercises.devices.bored_bracket import BRACKET, block, draw, parts
from exercises.devices.put_together import centre, chord, problem_of, sliced

solve, steps = problem_of(BRACKET, parts, holes=True, content="volume", length="in")


def prove(g):
    def slice_at(x):
        base = (g.l_y - chord(x - g.x_h, g.r_h)) * g.h_b
        wall = g.l_y * g.h_w if x < g.t_w else 0
        whole = base + wall
        return whole, whole * g.l_y / 2, base * g.h_b / 2 + wall * (g.h_b + g.h_w / 2)

    return sliced("volume", slice_at, 0, g.l_x, (g.t_w, g.x_h - g.r_h, g.x_h + g.r_h))


def mistakes(g):
    (base, wall), holes = parts(g)
    return {
        "hole_added": centre(BRACKET, [base, wall, *holes]),
        "wall_from_its_foot": centre(BRACKET, [base, block(g, "wall", g.t_w, 0, g.h_w)], holes),
        "corner_twice": centre(BRACKET, [base, block(g, "wall", g.t_w, 0, g.h_b + g.h_w)], holes),
    }
