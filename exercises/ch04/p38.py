"""4/38: the top of a disk in a turning bracket, increasing rates."""

from exercises.devices import disk_in_bracket as device

solve, steps, prove, draw = device.rim_problem("A")


def mistakes(g):
    a = solve(g)["a_A"]
    return {
        "no_P_dot": {"a_A": solve(g.but(P_dot=0))["a_A"]},
        "no_coriolis": {"a_A": a.without("coriolis")},
        "omega_dot_on_the_axis": {"a_A": a + a.frame.j * (g.omega_dot * g.r)},
        "half_coriolis": {"a_A": a.reweighted(coriolis=0.5)},
    }
