"""4/36: the side of a disk in a turning bracket, constant rates."""

from exercises.devices import disk_in_bracket as device

solve, steps, prove, draw = device.rim_problem("B")


def mistakes(g):
    a = solve(g)["a_B"]
    return {
        **device.wrong_accelerations_of_B(g, a),
        "no_centripetal": {"a_B": a.without("centripetal")},
        "P_the_other_way": {"v_B": solve(g.but(P=-g.P))["v_B"]},
    }
