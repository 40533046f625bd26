"""4/40: the top of a disk on an axle that sticks out of its turning bracket."""

from exercises.devices.disk_in_bracket import (
    alpha_disk,
    disk_in_bracket,
    figure,
    prove_rim,
    prove_turning,
    rim_from_turning,
    rim_motion,
    rim_point,
    rim_steps,
    turning,
    turning_steps,
)


def steps(g):
    yield from turning_steps(g)
    yield from rim_steps(g, "A")


follows = {"alpha_disk": alpha_disk, **rim_from_turning("A")}


def answers(frames, r):
    return {**turning(frames), **rim_motion(frames, "A", r)}


def solve(g):
    return answers(disk_in_bracket(g), g.r)


def prove(g):
    return {**prove_turning(g), **prove_rim(g, "A")}


def mistakes(g):
    frames = ground, _, disk = disk_in_bracket(g)
    _, alpha, _, a = answers(frames, g.r).values()
    r = rim_point(disk, "A", g.r) - disk.origin
    return {
        "no_coriolis": {"a_A": a.without("coriolis")},
        "alpha_zero": {"alpha_disk": 0 * alpha},
        "centre_not_accelerated": {"a_A": a - disk.origin.acceleration(ground)},
        "alpha_x_r_twice": {"a_A": a + alpha.cross(r)},
        "product_reversed": {"alpha_disk": -alpha},
    }


def draw(g, ax):
    figure(g, ax, omega_name=r"\omega_b")
