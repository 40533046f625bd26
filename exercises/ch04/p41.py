"""4/41: the side of a disk on an axle that sticks out of its turning bracket."""

from exercises.ch04.scene_disk_in_bracket import disk_in_bracket, draw_disk_in_bracket, prove_rim, prove_turning, rim_motion, turning


def given(g):
    return {"P": g.P, "omega": g.omega_b, "b": g.b}


def answers(frames, r):
    return {**turning(frames), **rim_motion(frames, "B", r)}


def solve(g):
    return answers(disk_in_bracket(**given(g)), g.r)


def prove(g):
    return {**prove_turning(**given(g)), **prove_rim("B", g.r, **given(g))}


def mistakes(g):
    frames = ground, _, disk = disk_in_bracket(**given(g))
    C, solved = disk.origin, answers(frames, g.r)
    alpha, v, a = solved["alpha_disk"], solved["v_B"], solved["a_B"]
    mixed = 2 * g.P * g.omega_b * g.r
    return {
        "bracket_forgotten": {"v_B": v.without("rotation") + C.velocity(ground)},
        "alpha_zero": {"alpha_disk": alpha.without("bracket x disk")},
        "centre_not_accelerated": {"a_B": a - C.acceleration(ground)},
        "square_of_the_sum": {"a_B": a - a.frame.i * mixed},
        "coriolis_of_the_top": {"a_B": a + a.frame.j * mixed},
    }


def draw(g, ax):
    draw_disk_in_bracket(ax, g.r, rim="AB", omega_name=r"\omega_b", **given(g))
