"""The figure of a problem as a PNG, drawn to scale from a student's own numbers."""

import io

from exercises.catalogue import Problem


def png(problem: Problem, values, size=(5.2, 4.0), dpi=100):
    """The figure as PNG bytes; ``values`` in the units of the text. Symbols without a number are drawn at the middle of their range."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=size, dpi=dpi)
    FigureCanvasAgg(figure)
    problem.code.draw(problem.base(drawn_at(problem, values)), figure.add_axes((0.02, 0.02, 0.96, 0.96)))
    out = io.BytesIO()
    figure.savefig(out, format="png")
    return out.getvalue()


def drawn_at(problem, values):
    """Values for every given and symbol: the student's, and the middle of the range for what has no number."""
    return {**{n: sum(s.vary) / 2 for n, s in problem.symbols.items()}, **values}
