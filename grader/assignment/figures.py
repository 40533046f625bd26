"""Draws the figure of a problem to scale, from a student's own numbers, as a PNG; and those of many
problems on one sheet.
"""

import io

from exercises.catalogue import Problem

SIZE = 5.2, 4.0  # inches
COLUMNS = 5  # of a sheet


def figure_png(problem: Problem, values, size=SIZE, dpi=100):
    """The figure of a problem as PNG bytes, None of one without a figure; ``values`` in the units
    of the text. A symbol without a number is drawn at the middle of its range.
    """
    if not problem.figure:
        return None
    return _png(_drawn(problem, values, size).figure, dpi)


def figure_faults(problem: Problem, values):
    """What is hard to read in the figure of a problem, in sentences."""
    from newton_euler.drawing.page.legibility import faults

    return faults(_drawn(problem, values, SIZE))


def contact_sheet(problems, values_of, dpi=72):
    """One PNG, as bytes, of the figures of many problems, each with its number; ``values_of`` gives
    the values of a problem.
    """
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
    return _png(sheet, dpi)


def _drawn(problem, values, size):
    """Axes with the figure of a problem."""
    from matplotlib.figure import Figure

    ax = Figure(figsize=size, dpi=100).add_axes((0.02, 0.02, 0.96, 0.96))
    _draw(problem, values, ax)
    return ax


def _draw(problem, values, ax):
    problem.code.draw(problem.base(drawing_values(problem, values)), ax)


def _png(figure, dpi):
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    FigureCanvasAgg(figure)
    out = io.BytesIO()
    figure.savefig(out, format="png", dpi=dpi)
    return out.getvalue()


def drawing_values(problem, values):
    """A value for every given and symbol: the student's, or the middle of the range where there is
    none.
    """
    return {**{n: sum(s.vary) / 2 for n, s in problem.symbols.items()}, **values}
