"""Executed chapters as input of Sphinx."""

from nbformat.v4 import new_code_cell, new_notebook, new_output

from newton_euler.classroom.widgets.on_pages import MOVING
from website.chapter_pages import page

PICTURE = '<img src="data:image/svg+xml;base64,PHN2Zy8+" alt="an arm">'


def test_without_an_engine_a_figure_with_sliders_is_a_still_picture(tmp_path):
    figure = {"text/html": PICTURE, MOVING: {"sliders": [], "along": {}}}
    for folder in (None, tmp_path):
        output = new_output("display_data", figure.copy())
        notebook = new_notebook(cells=[new_code_cell("figures.arm()", outputs=[output])])
        (cell,) = page(notebook, pictures=folder).cells
        (shown,) = (x.data for x in cell.outputs)
        assert list(shown) == ["text/html"]
        assert ("data-moving" in shown["text/html"]) == (folder is not None)
