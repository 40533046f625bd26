"""The cells of a page, run in its reader's browser, and figures that its sliders move."""

import ast
import sys
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from ..algebra.errors import NewtonEulerError
from ..classroom.widgets import interactive
from . import late
from .needed import needed, statements
from .shown import Shown, showing

if sys.platform == "emscripten":
    late.install()


@dataclass
class _Notebook:
    """The cells of a page that were run: their sources, names and figures, by number of cell."""

    ran: dict[int, str] = field(default_factory=dict)
    names: dict[str, Any] = field(default_factory=lambda: {"__name__": "__main__"})
    binders: dict[str, Any] = field(default_factory=dict)  # {name: the statement that bound it}
    failed: dict[str, Exception] = field(default_factory=dict)  # {name: why it is not there}
    figures: dict[int, list[interactive.MovingFigure]] = field(default_factory=dict)


_open: dict[str, _Notebook] = {}


def run(page: str, cells: list[str], number: int) -> dict[str, Any]:
    """Run a cell of the page ``cells``, after what it needs of those above that were not run:
    {"shown": [(kind, content) …]}, and "error" in words where it fails.
    """
    notebook = _open.setdefault(page, _Notebook())
    shown = Shown()
    notebook.figures[number] = []
    try:
        _prepare(notebook, cells, number)
        _run(notebook, number, cells[number], shown)
    except Exception as error:
        return {"shown": shown.items, "error": _in_words(_reason(error, notebook), number)}
    notebook.ran[number] = cells[number]
    return {"shown": shown.items}


def picture(
    page: str, cells: list[str], number: int, figure: int, values: dict[str, float]
) -> dict[str, str]:
    """The SVG of a figure of a cell for these values of its sliders, and what it shows, in words.
    A cell that was not run is run for it, unseen, after what it needs.
    """
    notebook = _open.setdefault(page, _Notebook())
    if number not in notebook.figures:
        run(page, cells, number)
        notebook.ran.pop(number, None)
    image, words = notebook.figures[number][figure].picture(values)
    return {"svg": image.decode(), "alt": words}


def _prepare(notebook, cells, number):
    """Run what a cell needs of those above that the reader did not run, unless it stands."""
    above = [notebook.ran.get(n, cell) for n, cell in enumerate(cells[:number])]
    for n, statement in needed(above, cells[number]):
        if any(notebook.binders.get(name) is not statement for name in statement.binds):
            try:
                with _shown_by(notebook, n, Shown()):
                    _execute([statement.node], notebook.names, n)
            except Exception as error:
                notebook.failed |= dict.fromkeys(statement.binds, error)
            else:
                _bound(notebook, statement)


def _bound(notebook, statement):
    for name in statement.binds:
        notebook.binders[name] = statement
        notebook.failed.pop(name, None)


def _run(notebook, number, source, shown):
    """Run a cell; the value of a last expression is shown, unless a semicolon follows."""
    body = ast.parse(source, _name(number)).body
    last = body.pop() if body and isinstance(body[-1], ast.Expr) else None
    with _shown_by(notebook, number, shown):
        _execute(body, notebook.names, number)
        if last:
            code = compile(ast.Expression(last.value), _name(number), "eval")
            value = eval(code, notebook.names)
            if value is not None and not source.rstrip().endswith(";"):
                sys.modules["IPython.display"].display(value)
    for statement in statements(source):
        _bound(notebook, statement)


@contextmanager
def _shown_by(notebook, number, shown):
    """What this block shows goes to ``shown``; a figure with sliders is kept."""

    def take(figure):
        figure.rehearse()
        kept = notebook.figures.setdefault(number, [])
        kept.append(figure)
        image, words = figure.picture(figure.start)
        shown.items.append(["figure", {"svg": image.decode(), "alt": words, **described(figure)}])

    before, interactive.taker = interactive.taker, take
    try:
        with showing(shown):
            yield
    finally:
        interactive.taker = before


def described(figure: interactive.MovingFigure) -> dict[str, Any]:
    """The sliders of a figure as a page needs them."""
    return {
        "sliders": [
            {
                "name": s.name, "label": s.label or s.name, "unit": s.unit, "start": s.start,
                "low": s.limits[0], "high": s.limits[1], "step": s.step,
            }
            for s in figure.sliders
        ]
    }  # fmt: skip


def _execute(body, names, number):
    exec(compile(ast.Module(body, []), _name(number), "exec"), names)


def _name(number):
    return f"<cell {number}>"


def _reason(error, notebook):
    """Why a name is not there, where a cell above could not bind it."""
    return notebook.failed.get(getattr(error, "name", None) or "", error)


def _in_words(error, number):
    """An error as a reader needs it, with its line in the cell."""
    line, trace = getattr(error, "lineno", None), error.__traceback__
    while trace:
        if trace.tb_frame.f_code.co_filename == _name(number):
            line = trace.tb_lineno
        trace = trace.tb_next
    kind = "" if isinstance(error, NewtonEulerError) else f"{type(error).__name__}: "
    return f"{kind}{getattr(error, 'msg', error)}" + (f" (line {line})" if line else "")
