"""4/41: the side of a disk on an axle that sticks out of its turning bracket."""

from exercises.devices.disk_in_bracket import (
    alpha_disk,
    disk_in_bracket,
    figure,
    prove_rim,
    prove_turning,
    rim_from_turning,
    rim_motion,
    rim_steps,
    turning,
    turning_steps,
    wrong_accelerations_of_B,
)


def steps(g):
    yield from turning_steps(g)
    yield from rim_steps(g, "B")


follows = {"alpha_disk": alpha_disk, **rim_from_turning("B")}


def answers(frames, r):
    return {**turning(frames), **rim_motion(frames, "B", r)}


def solve(g):
    return answers(disk_in_bracket(g), g.r)


def prove(g):
    return {**prove_turning(g), **prove_rim(g, "B")}


def mistakes(g):
    frames = ground, _, disk = disk_in_bracket(g)
    _, alpha, v, a = answers(frames, g.r).values()
    return {
        **wrong_accelerations_of_B(g, a),
        "bracket_forgotten": {"v_B": v.without("rotation") + disk.origin.velocity(ground)},
        "alpha_zero": {"alpha_disk": 0 * alpha},
        "centre_not_accelerated": {"a_B": a - disk.origin.acceleration(ground)},
    }


def draw(g, ax):
    figure(g, ax, omega_name=r"\omega_b")
