"""4/36: the side of a disk in a turning bracket, constant rates."""

from exercises.devices import disk_in_bracket as device


def solve(g):
    return device.rim_motion(device.disk_in_bracket(g), "B", g.r)


def steps(g):
    return device.rim_steps(g, "B")


def prove(g):
    return device.prove_rim(g, "B")


def mistakes(g):
    a = solve(g)["a_B"]
    return {
        **device.wrong_accelerations_of_B(g, a),
        "no_centripetal": {"a_B": a.without("centripetal")},
        "P_the_other_way": {"v_B": solve(g.but(P=-g.P))["v_B"]},
    }


def draw(g, ax):
    device.figure(g, ax, "B")
