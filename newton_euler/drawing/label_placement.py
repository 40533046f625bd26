"""Label placement: each label goes beside what it names, where it covers the fewest lines and no
other label.
"""

import os
from itertools import pairwise

from .primitives import FONT, STYLES


def place_labels(ax, canvas, renderer, before):
    """The labels as texts on ``ax``. ``before``: their places in the last picture of a film, which
    is updated.

    Greedy: one label after the other takes the cheapest of 16 directions and 4 distances, and stays
        there, since trying all combinations would
    take too long. The cost counts what the label would cover, the turn from its preferred direction
    and the distance; a place other than that of the last picture costs more, so that labels of a
    film do not jump.
    """
    import numpy as np

    _share_parser(renderer)
    covered = _points_on_lines(np, canvas)
    taken = np.empty((0, 4))
    # the edges of the figure, in points where the drawing's origin is zero
    (left, bottom), (right, top) = (
        ax.transData.inverted().transform(ax.figure.bbox.get_points()) / canvas.pt
    )
    angles = np.radians(np.arange(0, 360, 22.5))
    turns, rings = (a.ravel() for a in np.meshgrid(angles, [0, 7, 15, 26]))
    for order, note in sorted(enumerate(canvas.notes), key=lambda item: item[1].fixed is None):
        artist = ax.annotate(note.text, note.place, (0, 0), textcoords="offset points", ha="center", va="center",
                             color=note.colour, fontsize=FONT, fontweight=note.weight, zorder=9, annotation_clip=False)  # fmt: skip
        extent = artist.get_window_extent(renderer)
        w, h = (size * 72 / ax.figure.dpi / 2 for size in (extent.width, extent.height))
        x0, y0 = (c / canvas.pt for c in note.place)
        if note.fixed:
            x, y = np.array(note.fixed)[:, None]
        else:
            x, y = (
                np.cos(note.towards + turns) * (w + note.gap + rings),
                np.sin(note.towards + turns) * (h + note.gap + rings),
            )
        boxes = np.stack(
            (x0 + x - w - 1.5, x0 + x + w + 1.5, y0 + y - h - 1, y0 + y + h + 1), axis=1
        )
        best = 0
        if not note.fixed:
            off = (
                (boxes[:, 0] < left)
                | (boxes[:, 1] > right)
                | (boxes[:, 2] < bottom)
                | (boxes[:, 3] > top)
            )
            cost = (
                2 * _inside(covered, boxes)
                + 50 * _overlaps(taken, boxes)
                + 100 * off
                + 4 * (1 - np.cos(turns))
                + 0.4 * rings
            )
            if (order, note.text) in before:
                cost += 12 * (np.arange(len(cost)) != before[order, note.text])
            before[order, note.text] = best = np.argmin(cost)
        artist.set_position((x[best], y[best]))
        taken = np.vstack((taken, boxes[best]))
        yield artist


def _inside(positions, boxes):
    """How many of the positions lie in each box."""
    # most lie far away
    x, y = positions[
        (positions[:, 0] > boxes[:, 0].min()) & (positions[:, 0] < boxes[:, 1].max())
    ].T
    left, right, bottom, top = boxes.T[:, :, None]
    return ((x > left) & (x < right) & (y > bottom) & (y < top)).sum(axis=1)


def _overlaps(taken, boxes):
    """How many of the taken boxes overlap each box."""
    left, right, bottom, top = boxes.T[:, :, None]
    return (
        (taken[:, 0] < right) & (taken[:, 1] > left) & (taken[:, 2] < top) & (taken[:, 3] > bottom)
    ).sum(axis=1)


def _points_on_lines(np, canvas, step=3):
    """The positions, in points and every few points, along all lines and along the edges of thick
    ones: what a label should not cover.
    """
    ends, widths = [], []
    for stroke in canvas.strokes:
        flat = [canvas.project(p) for p in stroke.points]
        ends += pairwise(flat + flat[:1] * stroke.closed)
        widths += [STYLES[stroke.styles[0]]["linewidth"] if stroke.styles else 0] * (
            len(ends) - len(widths)
        )
    if not ends:
        return np.empty((0, 2))
    a, b = np.moveaxis(np.array(ends) / canvas.pt, 1, 0)
    widths = np.array(widths)
    thick = widths > 3
    along = (b - a)[thick]
    side = (
        along[:, ::-1]
        * (-1, 1)
        * (widths[thick] / 2 / np.maximum(np.hypot(*along.T), 1e-9))[:, None]
    )
    a, b = (np.concatenate((p, p[thick] + side, p[thick] - side)) for p in (a, b))
    count = np.ceil(np.hypot(*(b - a).T) / step).astype(int) + 1
    line = np.repeat(np.arange(len(count)), count)
    share = (np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count)) / count[line]
    return a[line] + share[:, None] * (b - a)[line]


_parsers = {}
# what was parsed holds open font files; two processes reading one of them get each other's bytes
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_parsers.clear)


def _share_parser(renderer):
    """Give all renderers with the same settings for formulas one parser: parsing takes
    milliseconds, and matplotlib keeps what is parsed with one renderer, that is for one figure.
    """
    if hasattr(renderer, "mathtext_parser"):
        from matplotlib import rcParams

        settings = (
            type(renderer),
            *(rcParams[name] for name in rcParams if name.startswith("mathtext.")),
        )
        renderer.mathtext_parser = _parsers.setdefault(settings, renderer.mathtext_parser)
