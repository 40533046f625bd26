"""The base of a sketch: it converts places and directions to triples, records drawing commands, and
renders them when the figure is finished. A command draws on a :class:`.Canvas`, for which the
length of a point of the page in metres is known: that with which everything fits on the page, or
that of a :class:`Window`, which the pictures of an animation share.
"""

import copy
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias

from ...algebra.errors import checked_but
from ...algebra.scalars import Triple, real_scalar, to_plain
from ...algebra.vectors import FrameError, Vector, cross3, dot3, sub3
from ...kinematics.frames import Frame, Point
from .occlusion import painters_order
from .on_axes import OnAxes
from .paper import AnyAxes, Page, Panel
from .primitives import Canvas
from .projection import circle, mean, moved, norm3, plane_view, space_view, unit3

Direction: TypeAlias = Vector | Sequence[float]
Place: TypeAlias = Point | Direction


@dataclass(frozen=True)
class Window:
    """What pictures share: the length of a point in metres, the middle of the page and of the scene
    (in space), and the places of labels, which each picture updates.
    """

    pt: float
    middle: tuple
    centre: tuple
    labels: dict = field(default_factory=dict)


MAX_PLACES = 10**6  # places of one curve at most


class Recorder:
    """Records drawing commands, and renders them when the figure is shown or saved."""

    @checked_but("ax", "ground")
    def __init__(
        self,
        ax: "AnyAxes | None",
        ground: Frame,
        azimuth: float = 35,
        elevation: float = 20,
        up: Literal["x", "y", "z"] = "z",
        plane: str | None = None,
        arrows: float = 62,
    ):
        if ax is None:
            ax = Page().panel
        elif not isinstance(ax, Panel) and not hasattr(ax, "add_patch"):
            raise FrameError(f"a sketch is on a Panel or the Axes of plt.subplots(); got {ax!r}")
        if not isinstance(ground, Frame):
            raise FrameError(f"the ground of Sketch(ax, ground) is a Frame; got {ground!r}")
        self.ax, self.frame = ax, ground
        self._surface = ax if isinstance(ax, Panel) else OnAxes(ax)
        self.arrows = self._length(arrows)
        self.view = plane_view(plane) if plane is not None else space_view(azimuth, elevation, up)
        self._commands: list = []
        self._extent: list = []  # places that fit on the page
        self._longest: dict = {}  # the longest arrow of each kind
        self._shortest = 0.25  # least length, relative to the longest
        self._pending = False
        self._window: Window | None = None  # window of the animation, if it is part of one
        self.drawn: Canvas | None = None  # what was rendered last

    def _place(self, P: Place) -> Triple:
        """A place as a triple of floats in the ground; it is added to the extent of the figure."""
        return self._extend([self._triple_of(P)])[0]

    def _triple_of(self, P: Place) -> Triple:
        """A place as a triple of floats in the ground."""
        return self._triple(P.position(self.frame) if isinstance(P, Point) else P, "place")

    def _places(self, *places: Place) -> list[Triple]:
        return [self._place(P) for P in places]

    def _triple(self, v: Any, what: str) -> Triple:
        if isinstance(v, Point):
            raise FrameError(
                f"a {what} is a Vector or a triple, got the point {v.name}; write B - A"
            )
        try:
            v = v.components(self.frame) if isinstance(v, Vector) else v
            if not hasattr(v, "__len__") or len(v) == 3:  # an endless iterator is not read
                v = tuple(v)
        except TypeError:
            v = (v,)
        if len(v) != 3:
            raise FrameError(
                f"a {what} is a {'Point, a ' * (what == 'place')}Vector or three numbers, got {v!r}"
            )
        try:
            v = tuple(map(self._float, v))
        except (TypeError, ValueError, OverflowError):
            raise FrameError(f"a sketch needs numbers, but the {what} is {v!r}") from None
        if not all(map(math.isfinite, v)):
            raise FrameError(f"the {what} {v!r} is not finite and cannot be drawn")
        return v

    def _unit(self, v: Direction) -> Triple:
        v = self._triple(v, "direction")
        if not norm3(v):
            raise FrameError("a direction of length zero points nowhere; give another vector")
        return unit3(v)

    def _axes_of(self, frame):
        """The unit vectors of a frame as triples."""
        if not isinstance(frame, Frame):
            raise FrameError(f"directions are the axes of a Frame, got {frame!r}")
        return [self._triple(e, "axis") for e in (frame.i, frame.j, frame.k)]

    def _length(self, x):
        size = self._number(x)
        if not 0 < size < math.inf:
            raise FrameError(f"a length is a positive number of metres; got {x!r}")
        return size

    def _number(self, x):
        """``x`` as a float; nan if it has no value as one."""
        try:
            return self._float(x)
        except (TypeError, ValueError, OverflowError):
            return math.nan

    @staticmethod
    def _float(x):
        """``x`` as a float; TypeError or ValueError for a quantity with a unit, and for text."""
        return float(to_plain(real_scalar(x)))

    def _or_default(self, x):
        """A length in metres; None and 0 stand for the default and are returned as they are."""
        return x if x is None or (isinstance(x, (int, float)) and not x) else self._length(x)

    def _several(self, places: Sequence[Place], what: str) -> list[Triple]:
        """A sequence of places."""
        try:
            if len(places) > MAX_PLACES:
                raise TypeError
            return self._places(*places)
        except TypeError:
            raise FrameError(f"{what} are a sequence of places; got {places!r}") from None

    def _rim(self, C, normal, radius):
        """The places of a circle, added to the extent of the figure."""
        return self._extend(circle(C, normal, self._length(radius)))

    @staticmethod
    def _circle_through(A, C, axis):
        """Centre, unit vectors to A and a quarter turn on, and radius of the circle through A."""
        centre = moved(C, dot3(sub3(A, C), axis), axis)
        out = sub3(A, centre)
        radius = norm3(out)
        if radius <= 1e-12 * norm3(sub3(A, C)):
            raise FrameError(f"a circle needs a place off its axis; {A} lies on that through {C}")
        e1 = unit3(out)
        return centre, e1, cross3(axis, e1), radius

    def _extend(self, points):
        self._extent.extend(points)
        return points

    def _record(self, command):
        self._commands.append(command)
        if not self._pending:
            self._pending = True
            self._surface.attach(self)

    def finish(self, renderer: Any = None) -> None:
        """Render what was recorded; it runs by itself when the figure is drawn, and once only."""
        if not self._pending:
            return
        self._pending = False
        window = self._window or _fitted([self], *self._surface.size())
        self.drawn = laid_out(self, window)
        self._surface.render(self.drawn, window, renderer)

    def _canvas(self, pt, centre):
        canvas = Canvas(self.view, pt, self._extent, centre)
        for command in self._commands:
            command(canvas)
        return canvas


def laid_out(sketch: Recorder, window: Window) -> Canvas:
    """The canvas of the picture in this window, its strokes in the order of drawing."""
    canvas = sketch._canvas(window.pt, window.centre)
    canvas.strokes = painters_order(canvas)
    return canvas


def figure_of(page: Page) -> Any:
    """A page as a figure of Matplotlib, for PNG."""
    from matplotlib.figure import Figure

    width, height = page.width, page.height
    figure = Figure(figsize=(width / 72, height / 72), dpi=100)
    for panel in page.axes:
        left, bottom, w, h = panel.box()
        if panel.plotted.calls:
            left, bottom, w, h = left + 46, bottom + 34, w - 54, h - 38
        ax: Any = figure.add_axes((left / width, bottom / height, w / width, h / height))
        for place, (text, size) in panel.titles.items():
            ax.set_title(text, fontsize=size, loc=place)
        for name, args, named in panel.plotted.calls:
            getattr(ax, name)(*args, **named)
        for sketch in panel.sketches:
            same = copy.copy(sketch)
            same.ax, same._surface, same._pending = ax, OnAxes(ax), True
            same._surface.attach(same)
        if not panel.plotted.calls:
            ax.set_axis_off()
    figure.suptitle(page.title, fontsize=11)
    return figure


def sketches_on(ax: Any) -> list[Recorder]:
    """The sketches on these axes that are not rendered yet."""
    return list(ax.sketches) if isinstance(ax, Panel) else OnAxes(ax).sketches()


def share_window(sketches: Sequence[Recorder]) -> Window:
    """Give sketches of one size one window, returned, and one scale for arrows of a kind."""
    longest: dict = {}
    for sketch in sketches:
        for kind, size in sketch._longest.items():
            longest[kind] = max(size, longest.get(kind, 0))
    for sketch in sketches:
        sketch._longest = longest  # before the fit, which draws arrows
        sketch._shortest = 0.0  # what moves is in proportion
    window = _fitted(sketches, *sketches[0]._surface.size())
    for sketch in sketches:
        sketch._window = window
    return window


def join_window(old: Recorder, window: Window, sketches: Sequence[Recorder]) -> Window:
    """Give these sketches the window and the scale of arrows of ``old``, which has shared them.
    Returns the window, or a wider one where they would leave it.
    """
    for sketch in sketches:
        for kind, size in sketch._longest.items():
            old._longest[kind] = old._longest.get(kind) or size
        sketch._longest, sketch._shortest = old._longest, 0.0
    width, height = sketches[0]._surface.size()
    (x, y), w, h = window.middle, width / 2 * window.pt, height / 2 * window.pt
    page = x - w, x + w, y - h, y + h
    box = _union([page, *(s._canvas(window.pt, window.centre).box() for s in sketches)])
    if box != page:
        left, right, bottom, top = box
        middle = (left + right) / 2, (bottom + top) / 2
        window = Window(_point(box, width, height), middle, window.centre, window.labels)
    for sketch in sketches:
        sketch._window = window
    return window


def _fitted(sketches, width, height):
    """The window for all sketches, by iteration: symbols in points change with its scale."""
    places = [P for sketch in sketches for P in sketch._extent]
    centre = mean(places) if places else (0.0, 0.0, 0.0)
    box = _union(Canvas(sketch.view, 0, sketch._extent, centre).box() for sketch in sketches)
    for _ in range(5):
        pt = _point(box, width, height)
        box = _union(sketch._canvas(pt, centre).box() for sketch in sketches)
        if abs(_point(box, width, height) / pt - 1) < 0.02:
            break
    left, right, bottom, top = box
    return Window(pt, ((left + right) / 2, (bottom + top) / 2), centre)


def _union(boxes):
    lefts, rights, bottoms, tops = zip(*boxes, strict=True)
    return min(lefts), max(rights), min(bottoms), max(tops)


def _point(box, width, height, margin=12):
    """The length of a point in metres with which the box fills a page, given in points."""
    left, right, bottom, top = box
    pt = max((right - left) / (width - 2 * margin), (top - bottom) / (height - 2 * margin))
    return pt or 1 / width  # a single place
