"""What makes a figure hard to read is found, and nothing else."""

import pytest

from newton_euler.drawing.page.legibility import faults
from tests.sketching import O, ground, sketch


def test_a_clear_figure_has_no_faults():
    s = sketch()
    s.rod(O, (1, 0, 0))
    s.axes(O, ground)
    s.label((1, 0, 0), "A")
    assert faults(s.ax) == []


@pytest.mark.parametrize(("view", "pair"), [
    ({"azimuth": 3, "elevation": 20}, "x and z"),
    ({"azimuth": 45, "elevation": 3}, "x and y"),
    ({"azimuth": 3, "elevation": 20, "up": "y"}, "y and z"),
])  # fmt: skip
def test_axes_on_one_line_are_a_fault(view, pair):
    s = sketch(**view)
    s.axes(O, ground)
    (fault,) = faults(s.ax)
    assert fault.startswith(f"the axes {pair} are seen on one line within")


def test_an_axis_that_points_at_the_eye_is_none():
    s = sketch(plane="xz")
    s.axes(O, ground)
    assert faults(s.ax) == []


def test_labels_that_overlap_are_a_fault():
    s = sketch()
    s.rod(O, (1, 0, 0))
    for name in "AB":
        s.label(O, name, offset=(0, 10))
    assert "the labels A and B overlap; leave more room, or give an offset" in faults(s.ax)


def test_a_label_outside_of_the_picture_is_a_fault():
    s = sketch()
    s.rod(O, (0, 1, 0))
    s.label((0, 1, 0), "A", offset=(60, 0))
    assert any(fault.startswith("the label A is partly outside") for fault in faults(s.ax))


def test_a_label_that_lines_cross_is_a_fault():
    s = sketch(plane="xz")
    s.line((0, 0, 0), (1, 0, 0), style="solid")
    s.label((0.5, 0, 0), "MOON", offset=(0, 0))
    assert faults(s.ax) == ["lines cross the label MOON; leave more room, or give an offset"]


def test_a_label_far_from_its_place_is_a_fault():
    s = sketch(plane="xz")
    s.line((0, 0, 0), (1, 0, 0), style="solid")
    s.label((0.5, 0, 0), "A", offset=(0, 60))
    (fault,) = faults(s.ax)
    assert fault.startswith("the label A stands 5")
    assert "points from its place" in fault
