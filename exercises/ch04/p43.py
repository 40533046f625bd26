"""4/43: the side of a disk in two brackets."""

from exercises.devices import disk_in_two_brackets as brackets

solve, steps, prove, draw = brackets.rim_problem("D")
follows = brackets.rim_from_turning("D")


def mistakes(g):
    frames, D = brackets.frames_and_point(g, "D")
    solved = brackets.answers(frames, D)
    alpha, v, a = solved["alpha_disk"], solved["v_D"], solved["a_D"]
    lost = alpha.terms["A x disk"].cross(D.position(D.frame))
    return {
        **brackets.wrong_alphas(alpha),
        "no_A_x_disk": {"alpha_disk": alpha.without("A x disk"), "a_D": a - lost},
        "D_moved_by_A": {"v_D": v + v.frame.j * (g.omega_2 * g.r)},
        "no_alpha_x_r": {"a_D": a.without("euler")},
    }
