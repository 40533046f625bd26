"""Figures of problems, to scale, from a student's own numbers."""

import io
from collections.abc import Callable, Iterable

from exercises.catalogue import Problem
from newton_euler.drawing import svg_of

from .cells import Values
from .legibility import faults

SIZE = 5.2, 4.0  # inches
COLUMNS = 5  # columns of a contact sheet


def figure_png(problem: Problem, values: Values) -> bytes | None:
    """The figure of a problem as PNG, or None; ``values`` in the units of the text. A symbol
    without a number is drawn at the middle of its range.
    """
    if not problem.figure:
        return None
    return _png(_drawn(problem, values).figure, 100)


def figure_svg(problem: Problem, values: Values) -> bytes | None:
    """The figure as SVG for print, with texts as outlines."""
    import matplotlib

    if not problem.figure:
        return None
    out = io.BytesIO()
    with matplotlib.rc_context({"svg.hashsalt": "", "svg.fonttype": "path"}):
        drawn = _drawn(problem, values).figure
        drawn.savefig(out, format="svg", bbox_inches="tight", metadata={"Date": None})
    return out.getvalue()


def figure_for_page(problem: Problem, values: Values) -> bytes | None:
    """The figure as a small SVG, with texts in the fonts of the page."""
    if not problem.figure:
        return None
    given = problem.base(drawing_values(problem, values))
    return svg_of(problem.code.draw, given, size=SIZE, alt=problem.figure).encode()


def figure_faults(problem: Problem, values: Values) -> list[str]:
    """What is hard to read in the figure of a problem, as sentences."""
    return faults(_drawn(problem, values))


def contact_sheet(problems: Iterable[Problem], values_of: Callable[[Problem], Values]) -> bytes:
    """A PNG with the figures of many problems and their numbers."""
    from matplotlib.figure import Figure

    problems = list(problems)
    columns = min(COLUMNS, len(problems))
    rows = -(-len(problems) // columns)
    sheet = Figure(figsize=(SIZE[0] * columns, SIZE[1] * rows))
    for n, p in enumerate(problems):
        row, column = divmod(n, columns)
        left, top = column / columns, 1 - row / rows
        sheet.text(left + 0.05 / columns, top - 0.03 / rows, p.id, va="top", weight="bold")
        place = left + 0.02 / columns, top - 0.98 / rows, 0.96 / columns, 0.96 / rows
        _draw(p, values_of(p), sheet.add_axes(place))
    return _png(sheet, 72)


def _drawn(problem, values):
    """Axes with the figure of a problem."""
    from matplotlib.figure import Figure

    ax = Figure(figsize=SIZE, dpi=100).add_axes((0.02, 0.02, 0.96, 0.96))
    _draw(problem, values, ax)
    return ax


def _draw(problem, values, ax):
    problem.code.draw(problem.base(drawing_values(problem, values)), ax)


def _png(figure, dpi):
    out = io.BytesIO()
    figure.savefig(out, format="png", dpi=dpi)
    return out.getvalue()


def drawing_values(problem: Problem, values: Values) -> Values:
    """A value for every given and symbol: from ``values``, or the middle of the range."""
    return {**{n: sum(s.vary) / 2 for n, s in problem.symbols.items()}, **values}
