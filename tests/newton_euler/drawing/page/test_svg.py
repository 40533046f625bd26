"""svg.py: the figure that matplotlib would draw, written without it."""

from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.figure import Figure

from newton_euler.drawing.page.glyphs import outline
from newton_euler.drawing.page.recorder import share_window, sketches_on
from newton_euler.drawing.page.svg import svg
from newton_euler.drawing.vocabulary import draw, entries


def paths(text):
    return list(ElementTree.fromstring(text).iter("{http://www.w3.org/2000/svg}path"))


@pytest.mark.parametrize("entry", entries(), ids=lambda entry: entry.shows)
def test_everything_that_a_sketch_can_draw_is_drawn_stroke_by_stroke(entry):
    figure = Figure(figsize=(4, 3))
    ax = figure.add_axes((0, 0, 1, 1))
    draw(entry, ax)
    window = share_window(sketches_on(ax))
    found = paths(svg(figure, sketches_on(ax), window))
    figure.draw_without_rendering()
    assert len(found) == len(ax.patches) + len(ax.texts)
    for path, patch in zip(found, ax.patches, strict=False):
        width = float(path.get("stroke-width"))
        assert width == patch.get_linewidth()


def test_places_are_those_of_matplotlib():
    figure = Figure(figsize=(4, 3), dpi=72)
    ax = figure.add_axes((0.1, 0, 0.8, 0.9))
    draw(entries()[8], ax)
    (sketch,) = sketches_on(ax)
    found = paths(svg(figure, [sketch], share_window([sketch])))
    figure.draw_without_rendering()
    for path, patch in zip(found, ax.patches, strict=False):
        seen = ax.transData.transform(patch.get_path().vertices[0])
        x, y = map(float, path.get("d")[1:].partition("L")[0].split())
        assert (x, 216 - y) == pytest.approx(seen, abs=0.6)


def test_a_text_with_a_formula_is_as_wide_as_matplotlib_draws_it():
    figure = Figure(dpi=72)
    for text in ("P", "$v_P$ = 1.20 m/s", r"$\dot\beta$"):
        box = figure.text(0, 0, text, fontsize=11).get_window_extent()
        letters = outline(text, 11, "normal")
        assert (letters.width, letters.above + letters.below) == pytest.approx(
            np.array(box.size), abs=1.5
        )
