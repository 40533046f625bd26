"""4/36: the side of a disk in a turning bracket, constant rates."""

from exercises.devices.disk_in_bracket import (
    disk_in_bracket,
    figure,
    prove_rim,
    rim_motion,
    rim_steps,
    wrong_accelerations_of_B,
)


def solve(g):
    return rim_motion(disk_in_bracket(g), "B", g.r)


def steps(g):
    return rim_steps(g, "B")


def prove(g):
    return prove_rim(g, "B")


def mistakes(g):
    a = solve(g)["a_B"]
    return {
        **wrong_accelerations_of_B(g, a),
        "no_centripetal": {"a_B": a.without("centripetal")},
        "P_the_other_way": {"v_B": solve(g.but(P=-g.P))["v_B"]},
    }


def draw(g, ax):
    figure(g, ax, "B")
