"""What makes a figure hard to read is reported, and nothing else."""

import pytest
from matplotlib.figure import Figure

from grader.assignment.legibility import faults
from newton_euler.drawing.vocabulary import draw, entries
from tests.sketching import O, ground, sketch


def test_a_clear_figure_and_an_axis_that_points_at_the_eye_have_no_faults():
    s = sketch()
    s.rod(O, (1, 0, 0))
    s.axes(O, ground)
    s.label((1, 0, 0), "A")
    assert faults(s.ax) == []
    s = sketch(plane="xz")
    s.axes(O, ground)
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


@pytest.mark.parametrize(("end", "at", "names", "offset", "fault"), [
    ((1, 0, 0), O, "AB", (0, 10), "the labels A and B overlap; leave more room, or give an offset"),
    ((0, 0, 1), (0, 0, 1), "A", (0, 90), "the label A is partly outside"),
    ((1, 0, 0), (0.5, 0, 0), ["MOON"], (0, 0), "lines cross the label MOON; leave more room, or give an offset"),
    ((1, 0, 0), (0.5, 0, 0), "A", (0, 60), "the label A stands 5"),
])  # fmt: skip
def test_a_label_that_cannot_be_read_is_a_fault(end, at, names, offset, fault):
    s = sketch(plane="xz")
    s.line(O, end, style="solid")
    for name in names:
        s.label(at, name, offset=offset)
    assert any(found.startswith(fault) for found in faults(s.ax))


@pytest.mark.parametrize("entry", entries(), ids=lambda entry: entry.shows)
def test_every_picture_of_the_page_of_sketches_can_be_read(entry):
    ax = Figure(figsize=(2.8, 2.1)).add_axes((0.02, 0.02, 0.96, 0.96))
    assert draw(entry, ax).ax is ax
    assert faults(ax) == []
