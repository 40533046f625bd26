"""A figure of Matplotlib that is redrawn for each value: for plots that a page cannot draw."""

import io
from typing import Any


class Plotted:
    """A figure of this size in inches, with its axes, as ``plt.subplots`` returns them."""

    def __init__(self, size: tuple[float, float], panels: tuple[int, int]):
        from matplotlib.figure import Figure

        self.figure = Figure(figsize=size)
        self.axes = self.figure.subplots(*panels)
        self._laid_out = False

    def sketches(self) -> list[Any]:
        """The sketches of the picture."""
        from ...drawing.page.recorder import sketches_on

        return [sketch for ax in self.figure.axes for sketch in sketches_on(ax)]

    def clear(self, title: str) -> None:
        """Empty the axes, under this title; until they are laid out, of their artists only."""
        self.figure.suptitle(title, fontsize=11)
        ax: Any  # the types of Matplotlib do not say that a locator may be None
        for ax in self.figure.axes:
            ax.set_axes_locator(None)
            if self._laid_out:
                ax.clear()
            else:
                for artist in (*ax.lines, *ax.patches, *ax.collections, *ax.texts, *ax.images):
                    artist.remove()

    def lay_out(self, sketches: list[Any]) -> None:
        """Sketches fill the figure except for titles; plots keep room for the labels of axes."""
        self._laid_out = True
        if not sketches:
            self.figure.tight_layout(rect=(0, 0, 1, 0.95))
            self.figure.set_layout_engine(None)  # else every picture is laid out, and drawn twice
            return
        axes = self.figure.axes
        titled = any(ax.get_title() for ax in axes)
        room = 0.01 if {sketch.ax for sketch in sketches} == {*axes} else 0.13
        self.figure.subplots_adjust(
            left=0.01 if axes[0] is sketches[0].ax else room, right=0.99 - room / 8,
            bottom=room, top=0.86 if titled else 0.93,
            wspace=0.01 + room, hspace=0.16 if titled else 0.02,
        )  # fmt: skip

    def saved(self, form: str, **options: Any) -> bytes:
        """The picture as a file of this form."""
        from matplotlib import rc_context

        out = io.BytesIO()
        with rc_context({"svg.hashsalt": "figure"}):
            self.figure.savefig(out, format=form, **options)
        return out.getvalue()
