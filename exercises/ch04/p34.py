"""4/34: the angular motion of a disk in a turning bracket, constant rates."""

from exercises.ch04.scene_disk_in_bracket import disk_in_bracket, draw_disk_in_bracket, prove_turning, turning


def given(g):
    return {"P": g.P, "omega": g.omega}


def solve(g):
    return turning(disk_in_bracket(**given(g)))


def prove(g):
    return prove_turning(**given(g))


def mistakes(g):
    _, bracket, _ = disk_in_bracket(**given(g))
    right = solve(g)
    return {
        "alpha_zero": {"alpha_disk": bracket.vector(0, 0, 0)},
        "P_cross_omega": {"alpha_disk": -right["alpha_disk"]},
        "only_P": {"omega_disk": right["omega_disk"].without("bracket")},
    }


def draw(g, ax):
    draw_disk_in_bracket(ax, **given(g))
