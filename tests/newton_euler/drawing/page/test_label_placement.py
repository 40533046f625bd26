"""labels.py: labels keep clear of each other, on the page, and at a fixed offset."""

from itertools import pairwise

import matplotlib
import pytest
from matplotlib.backends.backend_agg import RendererAgg

from newton_euler.drawing.page.covered import Covered
from newton_euler.drawing.page.on_axes import place_labels
from tests.sketching import O, ground, png, sketch, texts


def crowded():
    s = sketch()
    P = [ground.point(name, 0.2 * n, 0.1 * n * n, 0.1 * (n % 3)) for n, name in enumerate("ABCDEF")]
    for a, b in pairwise(P):
        s.rod(a, b)
        s.dimension(a, b, "$l$")
    for p in P:
        s.label(p, p.name)
    return s


def test_labels_are_legible_on_the_page_apart_or_at_their_offset():
    s = crowded()
    png(s)
    boxes = [t.get_window_extent() for t in s.ax.texts]
    assert len(boxes) == 11
    assert not [1 for n, a in enumerate(boxes) for b in boxes[:n] if a.overlaps(b)]
    s = crowded()
    png(s)
    page = s.ax.figure.bbox
    for t in s.ax.texts:
        box = t.get_window_extent()
        assert t.get_fontsize() >= 9
        assert page.x0 < box.x0 < box.x1 < page.x1
        assert page.y0 < box.y0 < box.y1 < page.y1
    s = sketch()
    s.rod(O, (1, 1, 1))
    s.label(O, "O", offset=(12, -9))
    assert texts(s)["O"].get_position() == pytest.approx((12, -9))
    assert texts(s)["O"].get_fontweight() == "bold"


def test_lines_that_a_body_hides_do_not_count_and_those_in_its_holes_do():
    def marks(*box, **plate):
        s = sketch(plane="xy")
        s.line((-1, 0, -1), (1, 0, -1), style="solid")
        corners = [(-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0)]
        s.plate(corners, [s.around(O, (r, 0, 0), ground.k) for r in plate.values()])
        s.finish()
        left, right = (side / s.drawn.pt for side in box)
        return Covered(s.drawn, s.drawn.shapes()).count((left, -2.5), (right, 2.5))

    assert marks(-1.8, 1.8) == 0
    assert marks(-0.45, 0.45, hole=0.5) > 10
    assert marks(0.55, 1.8, hole=0.5) == marks(-1.8, -0.55, hole=0.5) == 0


def test_single_letters_are_italic_except_names_of_points():
    s = sketch()
    s.dimension(O, (1, 0, 0), "b")
    s.dimension(O, (0, 1, 0), "2b")
    s.axes(O, ground, labels=["x", "$y_1$", "z"])
    s.label(O, "O")
    assert texts(s).keys() == {"$b$", "2b", "$x$", "$y_1$", "$z$", "O"}


def test_axes_are_drawn_without_labels_and_left_out_with_empty_ones():
    s = sketch(plane="xz")
    s.axes(O, ground, labels=["x", "", "z"])
    assert texts(s).keys() == {"$x$", "$z$"}
    # a shaft, a white edge and a head for each arrow, no circle for the axis that points away
    assert len(s.ax.patches) == 6
    s = sketch(plane="xz")
    s.axes(O, ground, labels="")
    s.finish()
    assert len(s.ax.patches) > 6
    assert not s.ax.texts


@pytest.mark.parametrize(("last", "now"), [(0, 0), (1, 1), (3 * 16 + 8, 0)])
def test_a_label_moves_from_where_it_was_only_if_that_is_much_better(last, now):
    """Positions 0 and 1 are free neighbours; the third is 26 points away."""
    s = sketch()
    s.rod((0, -1, 0), (0, 1, 0))
    s.label((0, 0, 1), "A")
    s.finish()
    before = {(0, "A"): last}
    list(place_labels(s.ax, s._canvas(0.01, (0, 0, 0)), RendererAgg(500, 400, 100), before))
    assert before == {(0, "A"): now}


def test_formulas_follow_the_settings_for_formulas():
    """All figures share the parsed formulas, until the settings change."""

    def drawn(fontset):
        with matplotlib.rc_context({"mathtext.fontset": fontset}):
            s = sketch()
            s.label(O, "$x_1$")
            return png(s)

    first = drawn("dejavusans")
    assert drawn("cm") != first
    assert drawn("dejavusans") == first
