"""4/18: the outer tip A of a bracket on a turning arm."""

from exercises.devices import bracket_on_arm as device
from exercises.tools import in_frame

tip, solve, steps, prove = device.problem_of("A", lambda g: g.a)


def mistakes(g):
    A, ground, arm = tip(g)
    return device.common_mistakes(A, ground) | in_frame(ground, {
        # all of alpha is omega_2 x omega_1
        "no_cross_product": {"a_A": A.acceleration(ground).without("euler")},
        "no_coriolis": {"a_A": A.acceleration(ground, via=arm).without("coriolis")},
    })  # fmt: skip


def draw(g, ax):
    s, B, A = device.sketch(g, ax, g.a)
    s.dimension(B, A, label="a")
