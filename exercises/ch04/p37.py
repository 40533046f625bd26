"""4/37: the angular motion of a disk in a turning bracket, growing rates."""

from exercises.ch04.scene_disk_in_bracket import disk_in_bracket, draw_disk_in_bracket, prove_turning, turning


def given(g):
    return {"P": g.P, "omega": g.omega, "P_dot": g.P_dot, "omega_dot": g.omega_dot}


def solve(g):
    return turning(disk_in_bracket(**given(g)))


def prove(g):
    return prove_turning(**given(g))


def mistakes(g):
    alpha = solve(g)["alpha_disk"]
    return {
        "no_product": {"alpha_disk": alpha.without("bracket x disk")},
        "product_reversed": {"alpha_disk": alpha.reweighted(**{"bracket x disk": -1})},
        "no_omega_dot": {"alpha_disk": alpha.without("bracket")},
        "no_P_dot": {"alpha_disk": alpha.without("disk")},
    }


def draw(g, ax):
    draw_disk_in_bracket(ax, **given(g))
