"""4/35: the top of a disk in a turning bracket, constant rates."""

from exercises.devices.disk_in_bracket import (
    disk_in_bracket,
    figure,
    prove_rim,
    rim_motion,
    rim_point,
    rim_steps,
)


def solve(g):
    return rim_motion(disk_in_bracket(g), "A", g.r)


def steps(g):
    return rim_steps(g, "A")


def prove(g):
    return prove_rim(g, "A")


def mistakes(g):
    frames = ground, _, disk = disk_in_bracket(g)
    a, r = rim_motion(frames, "A", g.r)["a_A"], rim_point(disk, "A", g.r) - disk.origin
    return {
        "no_coriolis": {"a_A": a.without("coriolis")},
        "half_coriolis": {"a_A": a.reweighted(coriolis=0.5)},
        "alpha_x_r_twice": {"a_A": a + disk.angular_acceleration(ground).cross(r)},
        "P_the_other_way": solve(g.but(P=-g.P)),
    }


def draw(g, ax):
    figure(g, ax, "A")
