"""covering.py: near things cover far ones, things on a face cover the face, and lines through a
face are cut.
"""

from newton_euler.drawing.page.occlusion import painters_order
from newton_euler.drawing.page.primitives import BODY, MARK, Canvas
from newton_euler.drawing.page.projection import plane_view, space_view
from tests.sketching import sketch


def ordered(view, *items):
    """The labels of the items (label, points, normal or None), the first drawn first."""
    canvas = Canvas(view, 0.01, [], (0, 0, 0))
    names = {}
    for name, points, normal in items:
        canvas.line(points, "thin", BODY, normal is not None, None, normal)
        names[id(canvas.strokes[-1])] = name
    return [names.get(id(s), "piece") for s in painters_order(canvas)]


SQUARE = [(5, 5, 0), (-5, 5, 0), (-5, -5, 0), (5, -5, 0)]


def test_the_nearer_covers_the_farther_and_a_floor_what_is_below():
    near, far = ((name, [(0, 0, z), (1, 0, z)], None) for name, z in (("near", 2), ("far", 1)))
    assert ordered(plane_view("xy"), near, far) == ["far", "near"]
    view = space_view(0, 20, "z")
    post = ("post", [(-4, 0, 0.1), (-4, 0, 0.5)], None)
    cellar = ("cellar", [(4, 0, -0.1), (4, 0, -0.5)], None)
    assert ordered(view, post, ("floor", SQUARE, (0, 0, 1)), cellar) == ["cellar", "floor", "post"]
    assert ordered(view, cellar, ("floor", SQUARE, (0, 0, -1)), post) == ["cellar", "floor", "post"]


def test_a_line_through_a_plate_is_cut_and_marks_lie_over_bodies():
    through, beside = (("shaft", [(x, 0, -1), (x, 0, 3)], None) for x in (0, 9))
    view, plate = space_view(35, 20, "z"), ("plate", SQUARE, (0, 0, 1))
    assert ordered(view, through, plate) == ["piece", "plate", "piece"]
    assert "shaft" in ordered(view, beside, plate)
    s = sketch()
    s.dot((-5, 0, 0))
    s.sphere((5, 0, 0), 1)
    s.finish()
    assert {p.get_zorder() for p in s.ax.patches} == {2 + BODY, 2 + MARK}
