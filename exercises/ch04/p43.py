"""4/43: the side of a disk in two brackets."""

from exercises.devices.disk_in_two_brackets import (
    answers,
    draw_two_brackets,
    frames_and_point,
    prove_rim,
    rim_from_turning,
    rim_steps,
    wrong_alphas,
)


def steps(g):
    return rim_steps(g, "D")


follows = rim_from_turning("D")


def solve(g):
    return answers(*frames_and_point(g, "D"))


def prove(g):
    return prove_rim(g, "D")


def mistakes(g):
    frames, D = frames_and_point(g, "D")
    solved = answers(frames, D)
    alpha, v, a = solved["alpha_disk"], solved["v_D"], solved["a_D"]
    lost = alpha.terms["A x disk"].cross(D.position(D.frame))
    return {
        **wrong_alphas(alpha),
        "no_A_x_disk": {"alpha_disk": alpha.without("A x disk"), "a_D": a - lost},
        "D_moved_by_A": {"v_D": v + v.frame.j * (g.omega_2 * g.r)},
        "no_alpha_x_r": {"a_D": a.without("euler")},
    }


def draw(g, ax):
    draw_two_brackets(g, ax)
