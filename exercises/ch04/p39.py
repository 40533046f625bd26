"""4/39: the side of a disk in a turning bracket, growing rates."""

from exercises.ch04.scene_disk_in_bracket import disk_in_bracket, draw_disk_in_bracket, prove_rim, rim_motion


def given(g):
    return {"P": g.P, "omega": g.omega, "P_dot": g.P_dot, "omega_dot": g.omega_dot}


def solve(g):
    return rim_motion(disk_in_bracket(**given(g)), "B", g.r)


def prove(g):
    return prove_rim("B", g.r, **given(g))


def mistakes(g):
    a = solve(g)["a_B"]
    mixed = 2 * g.P * g.omega * g.r
    return {
        "no_growth": {"a_B": solve(g.but(P_dot=0, omega_dot=0))["a_B"]},
        "square_of_the_sum": {"a_B": a - a.frame.i * mixed},
        "P_dot_the_other_way": {"a_B": solve(g.but(P_dot=-g.P_dot))["a_B"]},
        "coriolis_of_the_top": {"a_B": a + a.frame.j * mixed},
    }


def draw(g, ax):
    draw_disk_in_bracket(ax, g.r, rim="B", **given(g))
