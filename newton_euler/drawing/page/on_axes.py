"""A sketch on the axes of Matplotlib, which draws it when the figure is shown or saved."""

import os
from collections.abc import Iterator
from typing import Any

from .label_placement import label_shifts
from .primitives import FONT, STYLES, Canvas
from .projection import normal_of


class OnAxes:
    """The axes on which one sketch is; sketches on the same axes follow each other."""

    def __init__(self, ax: Any):
        self.ax = ax
        self._sketch: Any = None
        self._before: Any = None
        self._artists: list = []

    def size(self) -> tuple[float, float]:
        """Width and height of the axes in points."""
        width, height = (size * 72 / self.ax.figure.dpi for size in self.ax.bbox.size)
        return width, height

    def attach(self, sketch: Any) -> None:
        """Finish the sketch when the axes are drawn: matplotlib calls the locator before that."""
        self._sketch, self._before = sketch, self.ax.get_axes_locator()
        self.ax.set_axes_locator(self._locate)

    def _locate(self, ax, renderer):
        before = self._before
        self._sketch.finish(renderer)
        return before(ax, renderer) if before else ax.get_position(original=True)

    def render(self, canvas: Any, window: Any, renderer: Any = None) -> None:
        """Draw the strokes and the labels of a canvas, instead of those drawn before."""
        from matplotlib.path import Path
        from matplotlib.transforms import TransformedPath

        ax = self.ax
        if ax.get_axes_locator() == self._locate:
            ax.set_axes_locator(self._before)
        for artist in self._artists:
            artist.remove()
        (width, height), (x, y), pt = self.size(), window.middle, window.pt
        ax.set_xlim(x - width / 2 * pt, x + width / 2 * pt)
        ax.set_ylim(y - height / 2 * pt, y + height / 2 * pt)
        ax.set_aspect("equal", adjustable="datalim")
        ax.set_axis_off()
        clip = TransformedPath(Path.unit_rectangle(), ax.transAxes)
        self._artists = [p for s in canvas.strokes for p in _patches(s, ax, canvas, clip)]
        self._artists += place_labels(ax, canvas, renderer, window.labels)

    def sketches(self) -> list:
        """The sketches on the axes that are not drawn yet."""
        found, locator = [], self.ax.get_axes_locator()
        while isinstance(surface := getattr(locator, "__self__", None), OnAxes):
            found.append(surface._sketch)
            locator = surface._before
        return found


def _patches(stroke, ax, view, clip):
    """A stroke as patches on ``ax``, one for each style; one ``clip`` for all saves time."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    xy = [view.project(p) for p in stroke.points]
    path = Path(xy + xy[:1], closed=True) if stroke.closed else Path(xy)
    for hole in stroke.holes:  # a hole runs the other way round, which leaves it unfilled
        xy = [view.project(p) for p in hole]
        if view.depth(normal_of(hole)) * view.depth(normal_of(stroke.points)) > 0:
            xy.reverse()
        path = Path.make_compound_path(path, Path(xy + xy[:1], closed=True))
    changed: dict = {"clip_on": False, "zorder": 2 + stroke.layer}
    if not stroke.closed:
        changed["facecolor"] = "none"
    if stroke.cut:
        changed["capstyle"] = "butt"
    for style in stroke.styles:
        patch = PathPatch(path, **(STYLES[style] | changed))
        patch.set_clip_path(clip)
        yield ax.add_artist(patch)


def place_labels(ax: Any, canvas: Canvas, renderer: Any, before: dict) -> Iterator[Any]:
    """The labels as texts on ``ax``; ``before``, their last places in an animation, is updated."""
    _share_parser(renderer)
    corners = ax.transData.inverted().transform(ax.figure.bbox.get_points()) / canvas.pt
    edges, made = tuple(map(tuple, corners.tolist())), []

    def half_of(note):
        artist = ax.annotate(
            note.text, note.place, (0, 0), textcoords="offset points", ha="center", va="center",
            color=note.colour, fontsize=FONT, fontweight=note.weight, zorder=9,
            annotation_clip=False,
        )  # fmt: skip
        made.append(artist)
        return artist.get_window_extent(renderer).size * 72 / ax.figure.dpi / 2

    for _, shift in label_shifts(canvas, canvas.shapes(), half_of, edges, before):
        made[-1].set_position(shift)
        yield made[-1]


_parsers: dict = {}
# a parsed formula holds open font files; processes that share one get each other's bytes
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_parsers.clear)


def _share_parser(renderer):
    """Let renderers of equal settings share a parser: parsing a formula takes milliseconds."""
    if hasattr(renderer, "mathtext_parser"):
        from matplotlib import rcParams

        settings = (rcParams[name] for name in rcParams if name.startswith("mathtext."))
        key = type(renderer), *settings
        renderer.mathtext_parser = _parsers.setdefault(key, renderer.mathtext_parser)
