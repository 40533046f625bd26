"""Arrows to scale, and arrows of a rotation."""

import math
from itertools import pairwise

import numpy as np
import pytest

from newton_euler import moving
from newton_euler.drawing.page.primitives import BLACK, KINDS, MOVED
from tests.sketching import O, ground, png, sketch, texts, vertices


def test_an_arrow_reaches_from_A_to_B_with_its_label_in_the_middle():
    s = sketch(plane="xy")
    s.arrow((1, 2, 0), (4, 6, 0), "$r$", kind="force")
    s.arrow(O, (90, 0, 0), kind="force")
    shaft = next(v for v in vertices(s, KINDS["force"]) if len(v) == 2)
    assert shaft == pytest.approx(np.array([(1, 2), (4, 6)]))
    s = sketch(plane="xy")
    s.arrow(O, (4, 2, 0), "$r$")
    png(s)
    assert texts(s)["$r$"].xy == pytest.approx((2, 1))


@pytest.mark.parametrize(("axis", "sense"), [((0, 0, 1), 1), ((0, 0, -1), -1)])
def test_a_swing_runs_from_A_on_its_circle_right_handed(axis, sense):
    s = sketch(plane="xy")
    s.rod((1, 1, 0), (1, 3, 0))
    s.swing((1, 1, 5), (1, 3, 0), axis, r"$\dot\beta$")
    x, y = vertices(s, KINDS["rate"])[0].T
    assert (x[0], y[0]) == pytest.approx((1, 3))
    assert np.hypot(x - 1, y - 1) == pytest.approx(2)
    turned = np.unwrap(np.arctan2(y - 1, x - 1))[-1] - math.pi / 2
    assert 0.1 < sense * turned <= math.pi / 3 + 1e-9


def shafts(s, kind="velocity", colour=None):
    """The ends of the shaft of each arrow of a kind."""
    return [v for v in vertices(s, colour or KINDS[kind]) if len(v) == 2]


@pytest.mark.parametrize("size", [0, 1e-12])
def test_a_vector_that_is_zero_beside_the_longest_is_a_dot_with_its_label(size):
    s = sketch(plane="xy")
    s.vector(O, (1, 0, 0))
    s.vector((5, 0, 0), (0, size, 0), "$v_B$")
    (dot,) = [v for v in vertices(s, KINDS["velocity"]) if len(v) > 10]
    assert dot.mean(axis=0) == pytest.approx((5, 0), abs=0.1)
    assert len(shafts(s)) == 1
    assert "$v_B$" in texts(s)


def test_sizes_are_to_scale_in_the_decimals_of_the_longest_and_zero_is_a_dot():
    s = sketch(plane="xy")
    s.vector(O, (12.345, 0, 0), "$v_A$", size="m/s")
    s.vector(O, (0, 1.2, 0), "$v_B$", size="m/s")
    s.vector(O, (0, 0, 0), size="rad/s", kind="rate")
    assert {"$v_A$ = 12.3 m/s", "$v_B$ = 1.2 m/s", "0.00 rad/s"} <= set(texts(s))
    s = sketch(plane="xy", arrows=100)
    s.vector(O, (3, 0, 0))
    (shaft,) = shafts(s)
    assert shaft[1][0] == pytest.approx(100 * s.drawn.pt)
    s = sketch(plane="xy")
    s.turn(O, (0, 0, 0), "p")
    assert [len(v) > 10 for v in vertices(s, KINDS["rate"])] == [True]
    assert "$p$" in texts(s)


def test_axes_of_other_frames_than_the_ground_are_dashed_by_default():
    arm = ground.rotate("arm", "z", angle=0.3)
    cases = (ground, None, False), (arm, None, True), (arm, False, False), (ground, True, True)
    for frame, moved, dashed in cases:
        s = sketch()
        s.axes(O, frame, moved=moved)
        assert len(shafts(s, colour=MOVED)) == 3 * dashed
        assert len(shafts(s, colour=BLACK)) == 3 * (not dashed)


def test_the_terms_of_a_sum_join_head_to_tail_and_the_sum_closes_them():
    arm = ground.rotate("arm", "z", rate=2.0)
    v = arm.point("P", moving(1.0, 3.0), 0, 0).velocity(ground)
    s = sketch(plane="xy")
    s.sum((1, 1, 0), v, "$v_P$", kind="velocity", size="m/s")
    *steps, closing = shafts(s)
    assert closing[0] == pytest.approx(steps[0][0])
    for one, other in pairwise(steps):
        assert one[1] == pytest.approx(other[0])
    assert closing[1] == pytest.approx(steps[-1][1])
    lengths = sorted(np.hypot(*(b - a)) for a, b in steps)
    assert lengths[1] / lengths[0] == pytest.approx(3 / 2)
    assert {"origin = 0", "rotation", "relative", "$v_P$ = 3.61 m/s"} == set(texts(s))
