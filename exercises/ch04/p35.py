"""4/35: the top of a disk in a turning bracket, constant rates."""

from exercises.ch04.scene_disk_in_bracket import disk_in_bracket, draw_disk_in_bracket, prove_rim, rim_motion, turning


def given(g):
    return {"P": g.P, "omega": g.omega}


def solve(g):
    return rim_motion(disk_in_bracket(**given(g)), "A", g.r)


def prove(g):
    return prove_rim("A", g.r, **given(g))


def mistakes(g):
    frames = _, bracket, _ = disk_in_bracket(**given(g))
    alpha, a = turning(frames)["alpha_disk"], rim_motion(frames, "A", g.r)["a_A"]
    return {
        "no_coriolis": {"a_A": a.without("coriolis")},
        "half_coriolis": {"a_A": a.reweighted(coriolis=0.5)},
        "alpha_x_r_twice": {"a_A": a + alpha.cross(bracket.vector(0, 0, g.r))},
        "P_the_other_way": solve(g.but(P=-g.P)),
    }


def draw(g, ax):
    draw_disk_in_bracket(ax, g.r, rim="A", **given(g))
