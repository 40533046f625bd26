"""4/41: the side of a disk on an axle projecting from a turning shaft."""

from exercises.devices import disk_in_bracket as device

solve, steps, prove, draw, follows = device.whole_problem("B")


def mistakes(g):
    frames = ground, _, disk = device.disk_in_bracket(g)
    _, alpha, v, a = device.all_motion(frames, "B", g.r).values()
    return {
        **device.wrong_accelerations_of_B(g, a),
        "bracket_forgotten": {"v_B": v.without("rotation") + disk.origin.velocity(ground)},
        "alpha_zero": {"alpha_disk": 0 * alpha},
        "centre_not_accelerated": {"a_B": a - disk.origin.acceleration(ground)},
    }
