"""The stage of a figure that moves: its axes, the window that its pictures share, each picture."""

import io
from typing import Any

from ...algebra.errors import ArgumentError
from ...algebra.scalars import clipped
from .pictures import CSS_PIXELS, SHARP


class Stage:
    """A figure in inches with ``panels`` (rows, columns), on which ``draw(ax, **values)`` draws."""

    def __init__(self, draw: Any, size: Any, panels: Any):
        from matplotlib.figure import Figure

        self.draw, size = draw, _pair(size, "size", float)
        self.css_size = tuple(CSS_PIXELS * side for side in size)
        self.figure = Figure(figsize=size)
        self.axes = self.figure.subplots(*_pair(panels, "panels", int))
        self._bare = [len(ax.get_children()) for ax in self.figure.axes]
        self._plain = True  # nothing is drawn but sketches
        self._rehearsed = False
        self._window = self._one = None

    def rehearse(self, samples):
        """Record the sketches of many pictures, and find the window that holds them all."""
        from ...drawing.page.recorder import share_window

        sketches = [sketch for values in samples for sketch in self.sketches(values)]
        self._rehearsed = True
        self._lay_out(sketches)
        if sketches:
            self._one, self._window = sketches[0], share_window(sketches)

    def sketches(self, values):
        """The sketches of the picture for these values; empty if it has plots only."""
        try:
            return self._drawn(values)
        except Exception as error:
            error.add_note(f"This came up while the picture for {in_words(values)} was drawn.")
            raise

    def picture(self, values, title):
        """The picture for these values as SVG."""
        from ...drawing.page.recorder import join_window
        from ...drawing.page.svg import svg

        sketches = self._drawn(values)
        self.figure.suptitle(title or "", fontsize=11)
        if sketches:
            self._window = join_window(self._one, self._window, sketches)
        if self._plain:
            return svg(self.figure, sketches, self._window).encode()
        return self._saved("svg")

    def png(self):
        """The last picture as a PNG."""
        return self._saved("png", dpi=SHARP * CSS_PIXELS)

    def _saved(self, form, **options):
        from matplotlib import rc_context

        out = io.BytesIO()
        with rc_context({"svg.hashsalt": "figure"}):
            self.figure.savefig(out, format=form, **options)
        return out.getvalue()

    def _drawn(self, values):
        """The sketches of the picture for these values, which is on the axes then."""
        from ...drawing.page.recorder import sketches_on

        self._clear()
        returned = self.draw(self.axes, **values)
        if returned is not None:
            raise ArgumentError(
                f"draw(ax, …) draws on the axes that it gets and returns nothing; got {returned!r}"
            )
        found = [sketches_on(ax) for ax in self.figure.axes]
        bare = [len(ax.get_children()) for ax in self.figure.axes] == self._bare
        self._plain = self._plain and bare and all(found)
        return [sketch for of_ax in found for sketch in of_ax]

    def _clear(self):
        """Empty the axes: of unrendered sketches the titles, at first only plots; faster."""
        for ax in self.figure.axes:
            ax.set_axes_locator(None)
            if self._plain and len(ax.get_children()) == self._bare[self.figure.axes.index(ax)]:
                ax.set_title("")
            elif self._rehearsed:
                ax.clear()
            else:
                for artist in (*ax.lines, *ax.patches, *ax.collections, *ax.texts, *ax.images):
                    artist.remove()

    def _lay_out(self, sketches):
        """Sketches fill the figure except for titles; plots keep room for the labels of axes."""
        if sketches:
            axes = self.figure.axes
            titled = any(ax.get_title() for ax in axes)
            room = 0.01 if {sketch.ax for sketch in sketches} == {*axes} else 0.13
            self.figure.subplots_adjust(
                left=0.01 if axes[0] is sketches[0].ax else room, right=0.99 - room / 8,
                bottom=room, top=0.86 if titled else 0.93,
                wspace=0.01 + room, hspace=0.16 if titled else 0.02,
            )  # fmt: skip
        else:
            self.figure.tight_layout(rect=(0, 0, 1, 0.95))
            self.figure.set_layout_engine(None)  # else every picture is laid out, and drawn twice


def in_words(values):
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
