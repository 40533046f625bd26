"""4/23: the velocity of a rim point of a disk rolling in a circle."""

from exercises.answering import in_frame
from exercises.ch04.scene_rolling_disk import rim_point, rolling_disk, rolling_ratio, sketch
from exercises.proofs import rate


def solve(g, ratio=None):
    ground, axle, _, A = rolling_disk(g, ratio)
    return in_frame(axle, {"v_A": A.velocity(ground, via=axle)})


def prove(g):
    return {"v_A": rate(rim_point(g))}


def mistakes(g):
    v = solve(g)["v_A"]
    return {
        "no_turning_about_vertical": {"v_A": v.without("rotation")},
        "C_at_rest": {"v_A": v.without("origin")},
        "spin_reversed": solve(g, -rolling_ratio(g)),
        "one_turn_each_circuit": solve(g, -1),
    }


def draw(g, ax):
    sketch(g, ax)
