"""4/35: the top of a disk in a turning bracket, constant rates."""

from exercises.devices import disk_in_bracket as device

solve, steps, prove, draw = device.rim_problem("A")


def mistakes(g):
    frames = ground, _, disk = device.disk_in_bracket(g)
    a = device.rim_motion(frames, "A", g.r)["a_A"]
    r = device.rim_point(disk, "A", g.r) - disk.origin
    return {
        "no_coriolis": {"a_A": a.without("coriolis")},
        "half_coriolis": {"a_A": a.reweighted(coriolis=0.5)},
        "alpha_x_r_twice": {"a_A": a + disk.angular_acceleration(ground).cross(r)},
        "P_the_other_way": solve(g.but(P=-g.P)),
    }
