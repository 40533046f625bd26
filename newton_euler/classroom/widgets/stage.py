"""The stage of a figure that moves: its axes, the window that all its pictures share, and each
picture as a PNG.
"""

import io
from typing import Any

from ...algebra.errors import ArgumentError
from ...algebra.scalars import clipped
from .pictures import CSS_PIXELS, SHARP


class Stage:
    """A figure of this size in inches with ``panels`` (rows, columns), on which ``draw(ax,
    **values)`` draws.
    """

    def __init__(self, draw: Any, size: Any, panels: Any):
        self.draw, self.size = draw, _pair(size, "size", float)
        self.rows, self.columns = _pair(panels, "panels", int)
        self.css_size = tuple(CSS_PIXELS * side for side in self.size)
        self._sketches: list = []

    def rehearse(self, values):
        """Record the sketches of one picture, which the window shall hold."""
        try:
            self._sketches += self._drawn(values)[1]
        except Exception as error:
            error.add_note(f"This came up while the picture for {told(values)} was drawn.")
            raise

    def picture(self, values, title):
        """The picture for these values as a PNG."""
        from ...drawing.page.recorder import share_window

        figure, sketches = self._drawn(values)
        if sketches:
            share_window(self._sketches + sketches)
        if title:
            figure.suptitle(title, fontsize=11)
        out = io.BytesIO()
        figure.savefig(out, format="png", dpi=SHARP * CSS_PIXELS)
        return out.getvalue()

    def _drawn(self, values):
        """A figure with what is drawn for these values, and its sketches."""
        from matplotlib.figure import Figure

        from ...drawing.page.recorder import sketches_on

        figure = Figure(figsize=self.size)
        axes = figure.subplots(self.rows, self.columns)
        returned = self.draw(axes, **values)
        if returned is not None:
            raise ArgumentError(
                f"draw(ax, …) draws on the axes that it gets and returns nothing; got {returned!r}"
            )
        return figure, [sketch for ax in figure.axes for sketch in sketches_on(ax)]


def told(values):
    """The values in words."""
    return ", ".join(f"{name} = {x:g}" for name, x in values.items())


def _pair(pair, name, kind):
    """Two positive numbers."""
    try:
        first, second = (kind(x) for x in pair)
        if min(first, second) > 0:
            return first, second
    except (TypeError, ValueError):
        pass
    raise ArgumentError(f"{name} is a pair of positive numbers; got {clipped(pair)}")
