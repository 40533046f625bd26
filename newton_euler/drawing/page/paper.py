"""A page of panels, side by side, on which sketches are recorded and written as SVG without
Matplotlib.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, TypeAlias

from ...algebra.errors import ArgumentError, checked
from ...algebra.scalars import clipped
from .plots import SETTINGS, NeedsMatplotlib, Plot, Plots

TITLE = 12  # points, of a title whose size is not given
GAP = 0.02  # share of the page between panels and around them
LINE = 1.25  # distance of lines, by their size

if TYPE_CHECKING:
    from matplotlib.axes import Axes

AnyAxes: TypeAlias = "Panel | Axes"  # what a figure is drawn on


class Panel(Plots):
    """A part of a :class:`Page`: sketches or a plot, and a title."""

    def __init__(self, page: "Page", row: int, column: int):
        self.figure, self.row, self.column = page, row, column
        self.sketches: list[Any] = []
        self.plotted = Plot()
        self.titles: dict[str, tuple[str, float]] = {}  # {place: (text, size)}

    def set_title(self, text: str, fontsize: float = TITLE, loc: str = "center", **_: Any) -> None:
        """Set the title in the middle, or the one at the left; its size is in points, its lines are
        separated by ``\\n``.
        """
        self.titles[loc] = str(text), float(fontsize)

    def get_title(self) -> str:
        """The title in the middle."""
        return self.titles.get("center", ("", 0))[0]

    def box(self) -> tuple[float, float, float, float]:
        """Left, bottom, width and height on the page, in points."""
        page = self.figure
        room = page.room() if page.top is None else page.top
        head = 1.5 * TITLE if page.title else 0.0
        gap = GAP * page.width
        width = (page.width - gap * (page.columns + 1)) / page.columns
        height = (page.height - head - gap) / page.rows - gap - room
        bottom = gap + (page.rows - 1 - self.row) * (height + gap + room)
        return gap + self.column * (width + gap), bottom, width, height

    # -- the interface to sketches on it

    def attach(self, sketch: Any) -> None:
        """Take a sketch, which is written with the page."""
        self.sketches.append(sketch)

    def size(self) -> tuple[float, float]:
        """Width and height in points."""
        return self.box()[2:]

    def __getattr__(self, name: str) -> Callable[..., None]:
        if name.startswith("__"):
            raise AttributeError(name)
        if name[:4] == "set_" and name[4:] in SETTINGS:
            return lambda x, *end, **_: self.set(**{name[4:]: (x, *end) if end else x})
        raise NeedsMatplotlib(f"a panel of a page has no {name}; take the axes of matplotlib")


class Page:
    """A page of ``rows`` and ``columns`` of panels, its ``size`` (width, height) in inches.

    >>> from newton_euler import Frame
    >>> from newton_euler.drawing import Sketch
    >>> from newton_euler.drawing.page.svg import svg
    >>> page, ground = Page((6, 2), columns=2), Frame("ground")
    >>> left, right = page.panels()
    >>> Sketch(left, ground).rod((0, 0, 0), (0, 0, 2))
    >>> right.set_title("no rod")
    >>> svg(page, "On the left, a rod stands on its end; the right panel is empty.")[:4]
    '<svg'
    """

    @checked
    def __init__(self, size: Sequence[float] = (5, 4), rows: int = 1, columns: int = 1):
        if len(size) != 2 or not all(0 < side < 1e4 for side in size) or min(rows, columns) < 1:
            raise ArgumentError(
                "a page has a width and a height in inches, and one row and column or more; got "
                f"{clipped(size)}, {rows} and {columns}"
            )
        self.width, self.height = (72 * side for side in size)
        self.rows, self.columns = rows, columns
        self.axes = [Panel(self, row, column) for row in range(rows) for column in range(columns)]
        self.title = ""
        self.top: float | None = None  # the room for titles, if it is fixed

    @property
    def panel(self) -> Panel:
        """The first panel."""
        return self.axes[0]

    def panels(self) -> "Panel | Panels":
        """What ``plt.subplots`` returns: one panel, a row or a column of them, or rows of rows."""
        if len(self.axes) == 1:
            return self.panel
        if 1 in (self.rows, self.columns):
            return Panels(self.axes)
        starts = range(0, len(self.axes), self.columns)
        return Panels([Panels(self.axes[n : n + self.columns]) for n in starts])

    def suptitle(self, text: str, **_: Any) -> None:
        """Set the title of the whole page."""
        self.title = text or ""

    def subplots_adjust(self, **_: Any) -> None:
        """Nothing: panels find their own room."""

    tight_layout = subplots_adjust

    def empty(self) -> "Page":
        """A page without pictures that is like this one."""
        page = Page((self.width / 72, self.height / 72), self.rows, self.columns)
        page.top = self.top
        return page

    def lay_out(self) -> None:
        """Fix the room for titles, which later pictures on the page then share."""
        self.top = self.room()

    def room(self) -> float:
        """Points at the top of each row for the titles of panels, or a little air."""
        titles = [title for panel in self.axes for title in panel.titles.values() if title[0]]
        sizes = [size * LINE * len(text.split("\n")) for text, size in titles]
        return max(sizes) + 6 if sizes else 0.0


class Panels(list):
    """Panels in a row, or rows of them; ``flat`` has them one after the other."""

    @property
    def flat(self) -> Iterator[Panel]:
        """All panels, row by row."""
        for item in self:
            yield from item.flat if isinstance(item, Panels) else (item,)

    def __getitem__(self, place: Any) -> Any:
        if isinstance(place, tuple):
            row, place = place
            return list.__getitem__(self, row)[place]
        return list.__getitem__(self, place)
