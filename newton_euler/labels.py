"""Where labels go: beside what they name, where they cover the fewest lines and no other label."""

import os
from itertools import pairwise

from .primitives import FONT, LOOKS


def placed(ax, ink, renderer, before=None):
    """The notes as texts. ``before``: where they were in the last picture of a film; they move from there only if it is much better."""
    import numpy as np

    _parse_once(renderer)
    before = {} if before is None else before
    covered = _dots(np, ink)
    taken = np.empty((0, 4))
    left, right, bottom, top = _page(ax, ink)
    angles = np.radians(np.arange(0, 360, 22.5))
    turns, rings = (a.ravel() for a in np.meshgrid(angles, [0, 7, 15, 26]))
    for order, note in sorted(enumerate(ink.notes), key=lambda item: item[1].fixed is None):
        artist = ax.annotate(note.text, note.place, (0, 0), textcoords="offset points", ha="center", va="center",
                             color=note.colour, fontsize=FONT, fontweight=note.weight, zorder=9, annotation_clip=False)  # fmt: skip
        extent = artist.get_window_extent(renderer)
        w, h = (size * 72 / ax.figure.dpi / 2 for size in (extent.width, extent.height))
        x0, y0 = (c / ink.pt for c in note.place)
        if note.fixed is not None:
            x, y = np.array([x0 + note.fixed[0]]), np.array([y0 + note.fixed[1]])
        else:
            x = x0 + np.cos(note.towards + turns) * (w + note.gap + rings)
            y = y0 + np.sin(note.towards + turns) * (h + note.gap + rings)
        boxes = np.stack((x - w - 1.5, x + w + 1.5, y - h - 1, y + h + 1), axis=1)
        best = 0
        if note.fixed is None:
            off = (boxes[:, 0] < left) | (boxes[:, 1] > right) | (boxes[:, 2] < bottom) | (boxes[:, 3] > top)
            cost = 2 * _inside(covered, boxes) + 50 * _overlaps(taken, boxes) + 100 * off + 4 * (1 - np.cos(turns)) + 0.4 * rings
            if (order, note.text) in before:
                cost += 12 * (np.arange(len(cost)) != before[order, note.text])
            before[order, note.text] = best = np.argmin(cost)
        artist.set_position((x[best] - x0, y[best] - y0))
        taken = np.vstack((taken, boxes[best]))
        yield artist


def _inside(dots, boxes):
    """How many of the dots lie in each box."""
    x, y = dots[(dots[:, 0] > boxes[:, 0].min()) & (dots[:, 0] < boxes[:, 1].max())].T  # most lie far away
    left, right, bottom, top = boxes.T[:, :, None]
    return ((x > left) & (x < right) & (y > bottom) & (y < top)).sum(axis=1)


def _overlaps(taken, boxes):
    """How many of the boxes that are taken overlap each box."""
    left, right, bottom, top = boxes.T[:, :, None]
    return ((taken[:, 0] < right) & (taken[:, 1] > left) & (taken[:, 2] < top) & (taken[:, 3] > bottom)).sum(axis=1)


def _dots(np, ink, step=3):
    """Dots along all lines, every few points: what a label should not cover. In points."""
    ends, wide = [], []
    for stroke in ink.strokes:
        flat = [ink.view.flat(p) for p in stroke.points]
        ends += pairwise(flat + flat[:1] * stroke.closed)
        wide += [LOOKS[stroke.looks[0]]["linewidth"] if stroke.looks else 0] * (len(ends) - len(wide))
    if not ends:
        return np.empty((0, 2))
    a, b = np.moveaxis(np.array(ends) / ink.pt, 1, 0)
    thick = np.array(wide) > 3
    along = (b - a)[thick]
    side = along[:, ::-1] * (-1, 1) * (np.array(wide)[thick] / 2 / np.maximum(np.hypot(*along.T), 1e-9))[:, None]
    a, b = np.concatenate((a, a[thick] + side, a[thick] - side)), np.concatenate((b, b[thick] + side, b[thick] - side))
    count = np.ceil(np.hypot(*(b - a).T) / step).astype(int) + 1
    line = np.repeat(np.arange(len(count)), count)
    share = (np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count)) / count[line]
    return a[line] + share[:, None] * (b - a)[line]


def _page(ax, ink):
    """The edges of the figure, in points where the drawing's origin is zero."""
    corners = ax.transData.inverted().transform(ax.figure.bbox.get_points()) / ink.pt
    return corners[0, 0], corners[1, 0], corners[0, 1], corners[1, 1]


_parsers = {}
if hasattr(os, "register_at_fork"):  # what was parsed holds open font files; two processes reading one of them get each other's bytes
    os.register_at_fork(after_in_child=_parsers.clear)


def _parse_once(renderer):
    """To parse a formula takes milliseconds, and matplotlib keeps the result with one renderer, that is for one figure: the
    renderers of all figures share what was parsed, as long as the settings for formulas stay as they are."""
    if hasattr(renderer, "mathtext_parser"):
        from matplotlib import rcParams

        settings = (type(renderer), *(rcParams[name] for name in rcParams if name.startswith("mathtext.")))
        renderer.mathtext_parser = _parsers.setdefault(settings, renderer.mathtext_parser)
