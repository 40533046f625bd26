"""Arrows: those to scale, and those of a rotation."""

import math

import numpy as np
import pytest

from newton_euler.algebra import FrameError
from newton_euler.drawing.page.primitives import KINDS
from tests.sketching import O, ground, png, sketch, texts, vertices


def test_an_arrow_reaches_from_A_to_B_whatever_else_is_drawn():
    s = sketch(plane="xy")
    s.arrow((1, 2, 0), (4, 6, 0), "$r$", kind="force")
    s.arrow(O, (90, 0, 0), kind="force")
    s.finish()
    shaft = next(v for v in vertices(s, KINDS["force"]) if len(v) == 2)
    assert shaft == pytest.approx(np.array([(1, 2), (4, 6)]))


def test_the_label_of_an_arrow_stands_at_its_middle():
    s = sketch(plane="xy")
    s.arrow(O, (4, 2, 0), "$r$")
    png(s)
    assert texts(s)["$r$"].xy == pytest.approx((2, 1))


@pytest.mark.parametrize(("axis", "sense"), [((0, 0, 1), 1), ((0, 0, -1), -1)])
def test_a_swing_runs_from_A_on_its_circle_right_handed(axis, sense):
    s = sketch(plane="xy")
    s.rod((1, 1, 0), (1, 3, 0))
    s.swing((1, 1, 5), (1, 3, 0), axis, r"$\dot\beta$")
    s.finish()
    x, y = vertices(s, KINDS["rate"])[0].T
    assert (x[0], y[0]) == pytest.approx((1, 3))
    assert np.hypot(x - 1, y - 1) == pytest.approx(2)
    turned = np.unwrap(np.arctan2(y - 1, x - 1))[-1] - math.pi / 2
    assert 0.1 < sense * turned <= math.pi / 3 + 1e-9


def test_a_swing_about_an_axis_through_its_place_is_an_error():
    with pytest.raises(FrameError, match="a circle needs a place off its axis"):
        sketch().swing(O, (0, 0, 2), ground.k)
