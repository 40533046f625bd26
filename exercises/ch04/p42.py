"""4/42: the top of a disk in two brackets."""

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
    return rim_steps(g, "C")


follows = rim_from_turning("C")


def solve(g):
    return answers(*frames_and_point(g, "C"))


def prove(g):
    return prove_rim(g, "C")


def mistakes(g):
    frames, C = frames_and_point(g, "C")
    (ground, B, A, _), solved = frames, answers(frames, C)
    alpha, a = solved["alpha_disk"], solved["a_C"]
    coriolis = [
        C.acceleration(observer, via=frame).terms["coriolis"]
        for observer, frame in ((B, A), (ground, B))
    ]
    return {
        **wrong_alphas(alpha),
        "no_B_x_A": {"alpha_disk": alpha.without("B x A")},
        "no_alpha_x_r": {"a_C": a.without("euler")},
        "no_coriolis": {"a_C": a - coriolis[0] - coriolis[1]},
    }


def draw(g, ax):
    draw_two_brackets(g, ax)
