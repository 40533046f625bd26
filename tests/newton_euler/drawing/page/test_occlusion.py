"""covering.py: the near over the far, what lies on a face over the face, and lines through a face
cut.
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


def test_the_nearer_is_drawn_after_the_farther():
    assert ordered(
        plane_view("xy"),
        ("near", [(0, 0, 2), (1, 0, 2)], None),
        ("far", [(0, 0, 1), (1, 0, 1)], None),
    ) == ["far", "near"]


def test_what_lies_above_a_floor_covers_it_even_where_its_middle_is_farther_from_the_eye():
    view = space_view(0, 20, "z")
    post = ("post", [(-4, 0, 0.1), (-4, 0, 0.5)], None)
    cellar = ("cellar", [(4, 0, -0.1), (4, 0, -0.5)], None)
    assert ordered(view, post, ("floor", SQUARE, (0, 0, 1)), cellar) == ["cellar", "floor", "post"]
    assert ordered(view, cellar, ("floor", SQUARE, (0, 0, -1)), post) == ["cellar", "floor", "post"]


def test_a_line_through_a_plate_is_cut_and_one_beside_it_is_not():
    view = space_view(35, 20, "z")
    assert ordered(
        view, ("shaft", [(0, 0, -1), (0, 0, 3)], None), ("plate", SQUARE, (0, 0, 1))
    ) == ["piece", "plate", "piece"]
    assert "shaft" in ordered(
        view, ("shaft", [(9, 0, -1), (9, 0, 3)], None), ("plate", SQUARE, (0, 0, 1))
    )


def test_marks_lie_over_bodies():
    s = sketch()
    s.dot((-5, 0, 0))
    s.sphere((5, 0, 0), 1)
    s.finish()
    assert {p.get_zorder() for p in s.ax.patches} == {2 + BODY, 2 + MARK}
