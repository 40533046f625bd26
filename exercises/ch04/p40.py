"""4/40: the top of a disk on an axle projecting from a turning shaft."""

from exercises.devices import disk_in_bracket as device

solve, steps, prove, draw, follows = device.whole_problem("A")


def mistakes(g):
    frames = ground, _, disk = device.disk_in_bracket(g)
    _, alpha, _, a = device.all_motion(frames, "A", g.r).values()
    r = device.rim_point(disk, "A", g.r) - disk.origin
    return {
        "no_coriolis": {"a_A": a.without("coriolis")},
        "alpha_zero": {"alpha_disk": 0 * alpha},
        "centre_not_accelerated": {"a_A": a - disk.origin.acceleration(ground)},
        "alpha_x_r_twice": {"a_A": a + alpha.cross(r)},
        "product_reversed": {"alpha_disk": -alpha},
    }
