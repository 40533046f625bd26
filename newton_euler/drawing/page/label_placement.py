"""Label placement: each label goes where it covers the fewest lines and no other label."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence

from .covered import Covered, Place
from .primitives import Canvas, Note

# the places of a label beside its own: 4 distances in points, 16 turns; and what they cost
_PLACES = [
    (ring, 2 * math.pi * n / 16, 4 * (1 - math.cos(2 * math.pi * n / 16)) + 0.4 * ring)
    for ring in (0, 7, 15, 26)
    for n in range(16)
]
_CHEAP_FIRST = sorted(range(len(_PLACES)), key=lambda n: _PLACES[n][2])


def label_shifts(
    canvas: Canvas,
    shapes: Iterable[Iterable[Iterable[Place]]],
    half_of: Callable[[Note], Sequence[float]],
    edges: Sequence[Place],
    before: dict,
) -> Iterator[tuple[Note, Place]]:
    """Each label with the way from its place to its middle, in points.

    shapes : the outlines of each stroke on the page, in points
    half_of : gives half the width and height of a label, in points
    edges : of the figure, left bottom and right top, in points from the origin of the drawing
    before : the places of the labels in the previous picture of an animation; it is updated

    Greedy: one label after the other takes the cheapest of 16 directions and 4 distances, by what
    it would cover, the angle from its preferred direction and the distance; a place other than that
    of the previous picture costs more, so that labels do not jump.
    """
    if not canvas.notes:
        return
    covered = Covered(canvas, shapes)
    taken: list[tuple[Place, Place]] = []
    for note in placing_order(canvas.notes):
        half, place = half_of(note), tuple(x / canvas.pt for x in note.place)
        if note.fixed:
            shift = tuple(note.fixed)
        else:
            key = canvas.notes.index(note), note.text
            last = before.get(key)
            before[key] = best = _cheapest(note, place, half, covered, taken, edges, last)
            shift = _shift(note, half, best)
        taken.append(_box(place, shift, half))
        yield note, shift


def placing_order(notes: Iterable[Note]) -> list[Note]:
    """The labels in the order in which they are placed: those at a fixed offset first."""
    return sorted(notes, key=lambda note: note.fixed is None)


def _cheapest(note, place, half, covered, taken, edges, last):
    """The number of the cheapest place of a label, whose ``last`` one is cheaper if it has one."""
    least, best = math.inf, 0
    for n in _CHEAP_FIRST:
        cost = _PLACES[n][2]
        if cost > least:  # the places after it cost no less
            break
        box = low, high = _box(place, _shift(note, half, n), half)
        # weights by trial, on the figures of chapter 4
        if last is not None and n != last:
            cost += 12
        if not _within(low, edges) or not _within(high, edges):
            cost += 100
        cost += 50 * sum(_overlap(box, other) for other in taken)
        if cost <= least:
            cost += 2 * covered.count(low, high)
        if (cost, n) < (least, best):
            least, best = cost, n
    return best


def _shift(note, half, n):
    ring, turn, _ = _PLACES[n]
    angle = note.towards + turn
    away = note.gap + ring
    return math.cos(angle) * (half[0] + away), math.sin(angle) * (half[1] + away)


def _box(place, shift, half):
    """Two corners of the box of a label, with a little room around it."""
    x, y = place[0] + shift[0], place[1] + shift[1]
    w, h = half[0] + 1.5, half[1] + 1
    return (x - w, y - h), (x + w, y + h)


def _within(place, edges):
    (left, bottom), (right, top) = edges
    return left <= place[0] <= right and bottom <= place[1] <= top


def _overlap(a, b):
    (x0, y0), (x1, y1) = a
    (u0, v0), (u1, v1) = b
    return u1 > x0 and u0 < x1 and v1 > y0 and v0 < y1
