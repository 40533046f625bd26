"""Label placement: each label goes beside its place, where it covers the fewest lines and no other
label.
"""

import os
from itertools import pairwise

from .primitives import FONT, STYLES


def place_labels(ax, canvas, renderer, before):
    """The labels as texts on ``ax``. ``before``: their places in the previous picture of an
    animation, which is updated.

    Greedy: one label after the other takes the cheapest of 16 directions and 4 distances, and stays
    there; trying all combinations would take too long. The cost counts what the label would cover,
    the angle from its preferred direction and the distance; a place other than that of the previous
    picture costs more, so that labels do not jump.
    """
    import numpy as np

    _share_parser(renderer)
    covered, taken = _points_on_lines(np, canvas), np.empty((2, 0, 2))
    # the edges of the figure, in points from where the drawing has its origin
    left_bottom, right_top = (
        ax.transData.inverted().transform(ax.figure.bbox.get_points()) / canvas.pt
    )
    angles = np.radians(np.arange(0, 360, 22.5))
    turns, rings = (a.ravel() for a in np.meshgrid(angles, [0, 7, 15, 26]))
    for order, note in sorted(enumerate(canvas.notes), key=lambda item: item[1].fixed is None):
        artist = ax.annotate(
            note.text, note.place, (0, 0), textcoords="offset points", ha="center", va="center",
            color=note.colour, fontsize=FONT, fontweight=note.weight, zorder=9,
            annotation_clip=False,
        )  # fmt: skip
        half = artist.get_window_extent(renderer).size * 72 / ax.figure.dpi / 2
        angles = note.towards + turns
        directions = np.stack((np.cos(angles), np.sin(angles)), axis=1)
        shifts = [note.fixed] if note.fixed else directions * (half + note.gap + rings[:, None])
        middles = np.array(note.place) / canvas.pt + shifts
        low, high = middles - half - (1.5, 1), middles + half + (1.5, 1)
        best = 0
        if not note.fixed:
            off = ((low < left_bottom) | (high > right_top)).any(axis=1)
            # weights by trial, on the figures of chapter 4
            cost = 2 * _overlaps(covered, covered, low, high) + 50 * _overlaps(*taken, low, high)
            cost = cost + 100 * off + 4 * (1 - np.cos(turns)) + 0.4 * rings
            if (order, note.text) in before:
                cost += 12 * (np.arange(len(cost)) != before[order, note.text])
            before[order, note.text] = best = np.argmin(cost)
        artist.set_position(shifts[best])
        taken = np.concatenate((taken, [low[best : best + 1], high[best : best + 1]]), axis=1)
        yield artist


def _overlaps(lows, highs, low, high):
    """How many of the boxes (lows, highs) overlap each box (low, high); each is given by two
    corners, and a point is a box without size.
    """
    near = ((highs > low.min(axis=0)) & (lows < high.max(axis=0))).all(axis=1)  # most are not
    meets = (lows[near] < high[:, None]) & (highs[near] > low[:, None])
    return meets.all(axis=2).sum(axis=1)


def _points_on_lines(np, canvas, step=3):
    """Positions, in points and ``step`` apart, along all lines and along the edges of thick ones:
    what a label should not cover.
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
    halves = widths[thick] / 2 / np.maximum(np.hypot(*along.T), 1e-9)
    side = along[:, ::-1] * (-1, 1) * halves[:, None]
    a, b = (np.concatenate((p, p[thick] + side, p[thick] - side)) for p in (a, b))
    count = np.ceil(np.hypot(*(b - a).T) / step).astype(int) + 1
    line = np.repeat(np.arange(len(count)), count)
    share = (np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count)) / count[line]
    return a[line] + share[:, None] * (b - a)[line]


_parsers: dict = {}
# a parsed formula holds open font files; processes that share one get each other's bytes
if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_parsers.clear)


def _share_parser(renderer):
    """Let renderers with the same settings for formulas share one parser: parsing takes
    milliseconds, and matplotlib keeps the result for one renderer only, that is for one figure.
    """
    if hasattr(renderer, "mathtext_parser"):
        from matplotlib import rcParams

        settings = (rcParams[name] for name in rcParams if name.startswith("mathtext."))
        key = type(renderer), *settings
        renderer.mathtext_parser = _parsers.setdefault(key, renderer.mathtext_parser)
