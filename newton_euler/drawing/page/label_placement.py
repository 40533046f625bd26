"""Label placement: each label goes where it covers the fewest lines and no other label."""

import os
from itertools import pairwise

from .primitives import FONT, STYLES


def place_labels(ax, canvas, renderer, before):
    """The labels as texts on ``ax``; ``before``, their last places in an animation, is updated."""
    _share_parser(renderer)
    edges = ax.transData.inverted().transform(ax.figure.bbox.get_points()) / canvas.pt
    made = []

    def half_of(note):
        artist = ax.annotate(
            note.text, note.place, (0, 0), textcoords="offset points", ha="center", va="center",
            color=note.colour, fontsize=FONT, fontweight=note.weight, zorder=9,
            annotation_clip=False,
        )  # fmt: skip
        made.append(artist)
        return artist.get_window_extent(renderer).size * 72 / ax.figure.dpi / 2

    for _, shift in label_shifts(canvas, half_of, tuple(edges), before):
        made[-1].set_position(shift)
        yield made[-1]


def label_shifts(canvas, half_of, edges, before):
    """Each label with the way from its place to its middle, in points.

    half_of : gives half the width and height of a label, in points
    edges : of the figure, left bottom and right top, in points from the origin of the drawing

    Greedy: one label after the other takes the cheapest of 16 directions and 4 distances, by what
    it would cover, the angle from its preferred direction and the distance; a place other than that
    of the previous picture costs more, so that labels do not jump.
    """
    import numpy as np

    covered, taken = points_on_lines(np, canvas), np.empty((2, 0, 2))
    left_bottom, right_top = edges
    angles = np.radians(np.arange(0, 360, 22.5))
    turns, rings = (a.ravel() for a in np.meshgrid(angles, [0, 7, 15, 26]))
    for note in placing_order(canvas.notes):
        order = canvas.notes.index(note)
        half = np.asarray(half_of(note))
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
        taken = np.concatenate((taken, [low[best : best + 1], high[best : best + 1]]), axis=1)
        yield note, shifts[best]


def placing_order(notes):
    """The labels in the order in which they are placed: those at a fixed offset first."""
    return sorted(notes, key=lambda note: note.fixed is None)


def _overlaps(lows, highs, low, high):
    """How many boxes (lows, highs), or points, overlap each box (low, high), two corners each."""
    near = ((highs > low.min(axis=0)) & (lows < high.max(axis=0))).all(axis=1)  # most are not
    meets = (lows[near] < high[:, None]) & (highs[near] > low[:, None])
    return meets.all(axis=2).sum(axis=1)


def points_on_lines(np, canvas, step=3):
    """Positions, in points, ``step`` apart along all visible lines and the edges of thick ones."""
    ends, widths, owners = [], [], []
    for number, stroke in enumerate(canvas.strokes):
        for outline in stroke.outlines() if stroke.styles else ():
            flat = [canvas.project(p) for p in outline]
            ends += pairwise(flat + flat[:1] * stroke.closed)
            new = len(ends) - len(widths)
            widths += [STYLES[stroke.styles[0]]["linewidth"]] * new
            owners += [number] * new
    if not ends:
        return np.empty((0, 2))
    a, b = np.moveaxis(np.array(ends) / canvas.pt, 1, 0)
    widths, owners = np.array(widths), np.array(owners)
    thick = widths > 3
    along = (b - a)[thick]
    halves = widths[thick] / 2 / np.maximum(np.hypot(*along.T), 1e-9)
    side = along[:, ::-1] * (-1, 1) * halves[:, None]
    a, b = (np.concatenate((p, p[thick] + side, p[thick] - side)) for p in (a, b))
    owners = np.concatenate((owners, owners[thick], owners[thick]))
    count = np.ceil(np.hypot(*(b - a).T) / step).astype(int) + 1
    line = np.repeat(np.arange(len(count)), count)
    share = (np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count)) / count[line]
    points = a[line] + share[:, None] * (b - a)[line]
    return points[_seen(np, canvas, points, owners[line])]


def _seen(np, canvas, points, owners):
    """For each point, True unless a filled stroke after its own (``owners``) hides it."""
    from matplotlib.path import Path

    seen = np.full(len(points), True)
    for number, stroke in enumerate(canvas.strokes):
        if not (stroke.closed and any(STYLES[s]["facecolor"] != "none" for s in stroke.styles)):
            continue
        outline, *holes = (
            np.array([canvas.project(p) for p in places]) / canvas.pt
            for places in stroke.outlines()
        )
        low, high = outline.min(axis=0), outline.max(axis=0)
        in_box = ((points > low) & (points < high)).all(axis=1)
        near = np.flatnonzero(seen & (owners < number) & in_box)
        if len(near):
            covered = Path(outline).contains_points(points[near])
            for hole in holes:
                covered &= ~Path(hole).contains_points(points[near])
            seen[near[covered]] = False
    return seen


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
