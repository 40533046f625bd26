"""The cells of a page, run in its reader's browser, and figures that its sliders move."""

import sys
from collections import defaultdict
from contextlib import contextmanager
from typing import Any

from newton_euler.algebra.errors import NewtonEulerError
from newton_euler.classroom.widgets import interactive
from newton_euler.classroom.widgets.on_pages import described

from . import late
from .notebook import Notebook, name_of
from .output import CellOutput, showing

if sys.platform == "emscripten":
    late.install()


class _Page(Notebook):
    """A page, with the moving figures that its cells have shown."""

    def __init__(self) -> None:
        super().__init__()
        self.figures: dict[int, list[interactive.MovingFigure]] = {}


_open: defaultdict[str, _Page] = defaultdict(_Page)


def run(page: str, cells: list[str], number: int) -> dict[str, Any]:
    """Run a cell of the page ``cells``, after what it needs of those above that were not run:
    {"shown": [(kind, content) …]}, and "error" in words where it fails.
    """
    output = CellOutput()
    try:
        _run_cell(_open[page], cells, number, output)
    except Exception as error:
        if late.missing(error):
            raise  # the page may fetch the package and run the cell again
        return {"shown": output.items, "error": _in_words(error, number)}
    return {"shown": output.items}


def picture(
    page: str, cells: list[str], number: int, figure: int, values: dict[str, float]
) -> dict[str, str]:
    """The SVG of a figure of a cell for these values of its sliders, and what it shows, in words.
    If the cell was not run, it is run first, unseen, after what it needs.
    """
    here = _open[page]
    if not here.figures.get(number):
        _run_cell(here, cells, number, CellOutput())
    image, words = here.figures[number][figure].picture(values)
    return {"svg": image.decode(), "alt": words}


def _run_cell(page, cells, number, output):
    """Run a cell; its last value is shown, unless a semicolon follows."""
    page.figures[number] = []
    with _taking([], CellOutput()), showing(CellOutput()):
        stand = page.prepare(cells, number)
    with _taking(page.figures[number], output), showing(output):
        value = page.run(cells[number], number, stand)
        if value is not None and not cells[number].rstrip().endswith(";"):
            output.display(value)


@contextmanager
def _taking(figures, output):
    """In the block, figures with sliders are kept and shown."""

    def take(figure):
        figure.rehearse()
        figures.append(figure)
        image, words = figure.picture(figure.start)
        output.items.append(["figure", {"svg": image.decode(), "alt": words, **described(figure)}])

    before, interactive.taker = interactive.taker, take
    try:
        yield
    finally:
        interactive.taker = before


def _in_words(error, number):
    """An error as a reader needs it, with its line in the cell."""
    line, trace = getattr(error, "lineno", None), error.__traceback__
    while trace:
        if trace.tb_frame.f_code.co_filename == name_of(number):
            line = trace.tb_lineno
        trace = trace.tb_next
    kind = "" if isinstance(error, NewtonEulerError) else f"{type(error).__name__}: "
    words = "; ".join([str(getattr(error, "msg", error)), *getattr(error, "__notes__", ())])
    return f"{kind}{words}" + (f" (line {line})" if line else "")
