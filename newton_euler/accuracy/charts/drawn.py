"""A chart as drawn: picture, caption, alternative text and table, all from the same points."""

from dataclasses import dataclass, field
from html import escape
from typing import Any

from ...classroom import show_figure


@dataclass(frozen=True, eq=False)
class DrawnChart:
    """A chart that was measured and drawn: its subject ``title``, the ``points`` (of a map, the
    choices), a ``caption`` that follows from them, the ``table`` to print, and the ``figure``.
    """

    title: str
    points: tuple
    caption: str
    table: str
    figure: Any = field(repr=False)

    @property
    def alt(self) -> str:
        """The alternative text of the picture."""
        return f"Chart: {self.title}. {self.caption}"

    def show(self) -> None:
        """Display the picture and its caption in a notebook; elsewhere print the caption."""
        try:
            from IPython.display import HTML, display
        except ImportError:
            print(self.caption)
            return
        show_figure(self.figure, self.alt)
        display(HTML(f"<figcaption>{escape(self.caption)}</figcaption>"))

    def __str__(self) -> str:
        return self.table

    def __repr__(self) -> str:
        return f"<chart of {self.title}: {len(self.points)} points>"

    def _ipython_display_(self):
        """Nothing: as the last value of a cell it would be shown a second time."""
