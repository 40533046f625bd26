"""4/39: the side of a disk in a turning bracket, increasing rates."""

from exercises.devices import disk_in_bracket as device

solve, steps, prove, draw = device.rim_problem("B")


def mistakes(g):
    return {
        **device.wrong_accelerations_of_B(g, solve(g)["a_B"]),
        "no_growth": {"a_B": solve(g.but(P_dot=0, omega_dot=0))["a_B"]},
        "P_dot_the_other_way": {"a_B": solve(g.but(P_dot=-g.P_dot))["a_B"]},
    }
