"""What makes a figure hard to read: labels in the way, astray or cut off, axes that look alike."""

import math
from itertools import combinations
from typing import Any

from newton_euler.algebra.vectors import sub3
from newton_euler.drawing.page.covered import Covered
from newton_euler.drawing.page.label_placement import placing_order
from newton_euler.drawing.page.recorder import sketches_on

ALIKE = 10  # degrees between two axes, as seen, below which they are hard to tell apart
CROSSED = 3  # points on lines, 3 points of the page apart, that a label may cover
STRAY = 22  # the most points of the page from a label to its place


def faults(ax: Any) -> list[str]:
    """What is hard to read in the sketches on ``ax``, in sentences; the figure is finished by it.

    >>> from matplotlib.figure import Figure
    >>> from newton_euler import Frame
    >>> from newton_euler.drawing import Sketch
    >>> ax, ground = Figure().add_subplot(), Frame("ground")
    >>> s = Sketch(ax, ground, azimuth=2)
    >>> s.axes((0, 0, 0), ground)
    >>> print(*faults(ax))
    the axes x and z are seen on one line within 6 degrees; choose another azimuth or elevation
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    sketches = sketches_on(ax)
    FigureCanvasAgg(ax.figure).draw()  # finishes the sketches and places their labels
    found = list(_label_faults(ax))
    for drawn in filter(None, (sketch.drawn for sketch in sketches)):
        found += [fault for triad in drawn.triads for fault in _alike(drawn, *triad)]
        found += _strays(ax, drawn)
    return found


def _alike(view, origin, axes):
    """The faults of one system of axes. One that points at the eye is drawn as a circle."""
    seen = [(text, view.project(v)) for tip, text in axes if view.is_seen(v := sub3(tip, origin))]
    for (one, a), (other, b) in combinations(seen, 2):
        apart = math.degrees(math.atan2(abs(a[0] * b[1] - a[1] * b[0]), a[0] * b[0] + a[1] * b[1]))
        apart = min(apart, 180 - apart)
        if apart < ALIKE:
            yield (
                f"the axes {one} and {other} are seen on one line within {apart:.0f} degrees; "
                "choose another azimuth or elevation"
            )


def _label_faults(ax):
    """Labels that leave the picture, and those that overlap."""
    boxes = [(text.get_text(), text.get_window_extent()) for text in ax.texts]
    page = ax.figure.bbox
    for text, box in boxes:
        if box.x0 < page.x0 or box.x1 > page.x1 or box.y0 < page.y0 or box.y1 > page.y1:
            yield f"the label {text} is partly outside of the picture; shorten it or move it"
    for (one, a), (other, b) in combinations(boxes, 2):
        if a.overlaps(b):
            yield f"the labels {one} and {other} overlap; leave more room, or give an offset"


def _strays(ax, drawn):
    """Labels that lines cross, and those far from what they name."""
    covered, to_points = Covered(drawn, drawn.shapes()), ax.transData.inverted()
    for text, note in zip(ax.texts, placing_order(drawn.notes), strict=True):
        box = to_points.transform(text.get_window_extent().get_points()) / drawn.pt
        low, high = box.tolist()
        crossed = covered.count(low, high)
        place = [x / drawn.pt for x in note.place]
        gaps = zip(low, place, high, strict=True)
        away = math.hypot(*(max(0, a - x, x - b) for a, x, b in gaps))
        if crossed > CROSSED:
            yield f"lines cross the label {note.text}; leave more room, or give an offset"
        if away > STRAY:
            yield (
                f"the label {note.text} stands {away:.0f} points from its place, where it found "
                "room; leave more room there"
            )
