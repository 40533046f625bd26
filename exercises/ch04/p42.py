"""4/42: the top of a disk in two brackets."""

from exercises.devices import disk_in_two_brackets as brackets

solve, steps, prove, draw = brackets.rim_problem("C")
follows = brackets.rim_from_turning("C")


def mistakes(g):
    frames, C = brackets.frames_and_point(g, "C")
    (ground, B, A, _), solved = frames, brackets.answers(frames, C)
    alpha, a = solved["alpha_disk"], solved["a_C"]
    coriolis = lambda observer, frame: C.acceleration(observer, via=frame).terms["coriolis"]
    return {
        **brackets.wrong_alphas(alpha),
        "no_B_x_A": {"alpha_disk": alpha.without("B x A")},
        "no_alpha_x_r": {"a_C": a.without("euler")},
        "no_coriolis": {"a_C": a - coriolis(B, A) - coriolis(ground, B)},
    }
