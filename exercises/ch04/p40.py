"""4/40: the top of a disk on an axle that sticks out of its turning bracket."""

from exercises.ch04.scene_disk_in_bracket import disk_in_bracket, draw_disk_in_bracket, prove_rim, prove_turning, rim_motion, rim_point, turning


def given(g):
    return {"P": g.P, "omega": g.omega_b, "b": g.b}


def answers(frames, r):
    return {**turning(frames), **rim_motion(frames, "A", r)}


def solve(g):
    return answers(disk_in_bracket(**given(g)), g.r)


def prove(g):
    return {**prove_turning(**given(g)), **prove_rim("A", g.r, **given(g))}


def mistakes(g):
    frames = ground, _, disk = disk_in_bracket(**given(g))
    solved = answers(frames, g.r)
    alpha, a = solved["alpha_disk"], solved["a_A"]
    return {
        "no_coriolis": {"a_A": a.without("coriolis")},
        "alpha_zero": {"alpha_disk": alpha.without("bracket x disk")},
        "centre_not_accelerated": {"a_A": a - disk.origin.acceleration(ground)},
        "alpha_x_r_twice": {"a_A": a + alpha.cross(rim_point(disk, "A", g.r) - disk.origin)},
        "product_reversed": {"alpha_disk": alpha.reweighted(**{"bracket x disk": -1})},
    }


def draw(g, ax):
    draw_disk_in_bracket(ax, g.r, rim="AB", omega_name=r"\omega_b", **given(g))
