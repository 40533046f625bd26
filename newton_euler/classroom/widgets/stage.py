"""The stage of a figure that moves: its page, the window that its pictures share, each picture."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from ...algebra.errors import ArgumentError
from ...algebra.places import add_place
from .pictures import CSS_PIXELS, png_of, saved


class Stage:
    """A page of a ``size`` in inches with ``panels`` (rows, columns), on which ``draw(ax,
    **values)`` draws; a figure of Matplotlib once it draws what only that can.
    """

    def __init__(self, draw: Callable[..., Any], size: Sequence[float], panels: Sequence[int]):
        from ...drawing.page.paper import Page

        self.draw, self._size, self._panels = draw, size, panels
        self.page = Page(size, *panels)
        self.css_size = tuple(CSS_PIXELS * side for side in size)
        self._plotted: Plotted | None = None
        self._window: Any = None
        self._one: Any = None
        self._title = ""

    @property
    def is_plotted(self) -> bool:
        """True if it draws what only Matplotlib can."""
        return self._plotted is not None

    def rehearse(self, samples: Iterable[Mapping[str, Any]]) -> None:
        """Record the sketches of many pictures, and find the window that holds them all."""
        from ...drawing.page.recorder import share_window

        samples = list(samples)
        found = self._all(samples)
        if self._plotted and any(sketch.ax.figure is not self._plotted.figure for sketch in found):
            found = self._all(samples)  # the first ones were on a page
        if self._plotted:
            self._plotted.lay_out(found)
        else:
            self.page.lay_out()
        if found:
            self._one, self._window = found[0], share_window(found)

    def _all(self, samples):
        return [sketch for values in samples for sketch in self.sketches(values)]

    def sketches(self, values: Mapping[str, Any]) -> list[Any]:
        """The sketches of the picture for these values; empty if it has plots only."""
        try:
            return self._drawn(values)
        except Exception as error:
            add_place(error, f"This came up while the picture for {in_words(values)} was drawn.")
            raise

    def picture(self, values: Mapping[str, Any], title: str | None = None, alt: str = "") -> bytes:
        """The picture for these values as SVG."""
        from ...drawing.page.recorder import join_window
        from ...drawing.page.svg import svg

        self._title = title or ""
        sketches = self._drawn(values)
        if sketches and self._window:
            self._window = join_window(self._one, self._window, sketches)
        if self._plotted:
            return saved(self._plotted.figure, format="svg")
        return svg(self.page, alt).encode()

    def png(self) -> bytes | None:
        """The last picture as a PNG, or None where there is no Matplotlib."""
        return png_of(self._plotted.figure if self._plotted else self.page)

    def _drawn(self, values):
        """Draw the picture for these values on the panels, and return its sketches."""
        from ...drawing.page.paper import NeedsMatplotlib

        if self._plotted is None:
            try:
                self.page = self.page.empty()
                self.page.suptitle(self._title)
                self._draw_on(self.page.panels(), values)
                return [sketch for panel in self.page.axes for sketch in panel.sketches]
            except NeedsMatplotlib:
                self._plotted = Plotted(self._size, self._panels)
        self._plotted.clear(self._title)
        self._draw_on(self._plotted.axes, values)
        return self._plotted.sketches()

    def _draw_on(self, axes, values):
        found = self.draw(axes, **values)
        if found is not None:
            raise ArgumentError(f"draw(ax, …) draws on its axes and returns nothing; got {found!r}")


class Plotted:
    """A figure of Matplotlib of this size in inches, with axes as ``plt.subplots`` returns them,
    redrawn for each value: for plots that a page cannot draw.
    """

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


def in_words(values: Mapping[str, float]) -> str:
    """The values in words."""
    return ", ".join(f"{name} = {x:g}" for name, x in values.items())
