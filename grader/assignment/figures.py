"""Draws the figure of a problem to scale, from a student's own numbers, as a PNG."""

import io

from exercises.catalogue import Problem


def figure_png(problem: Problem, values, size=(5.2, 4.0), dpi=100):
    """The figure of a problem as PNG bytes; ``values`` in the units of the text. A symbol without a
    number is drawn at the middle of its range.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=dpi)
    FigureCanvasAgg(figure)
    problem.code.draw(
        problem.base(drawing_values(problem, values)), figure.add_axes((0.02, 0.02, 0.96, 0.96))
    )
    out = io.BytesIO()
    figure.savefig(out, format="png")
    return out.getvalue()


def drawing_values(problem, values):
    """A value for every given and symbol: the student's, or the middle of the range where there is
    none.
    """
    return {**{n: sum(s.vary) / 2 for n, s in problem.symbols.items()}, **values}
