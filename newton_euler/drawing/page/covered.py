"""Where the lines of a picture are: on a grid, drawn over as the picture is, so that what a face
hides is not there.
"""

import math
from collections.abc import Iterable
from itertools import pairwise
from typing import TypeAlias

from .primitives import STYLES, Canvas

CELL = 1.5  # points, a side of a cell of the grid
STEP = 3  # points between marks along a line
FILLED = {name for name, style in STYLES.items() if style["facecolor"] != "none"}
_MOST = 4000  # cells in a row or a column

Place: TypeAlias = tuple[float, float]  # coordinates on the page, in points


class Covered:
    """The marks along all visible lines of ``canvas`` and the edges of thick ones; ``shapes``: the
    outlines of each of its strokes on the page, in points.
    """

    def __init__(self, canvas: Canvas, shapes: Iterable[Iterable[Iterable[Place]]]):
        self.left, right, self.bottom, top = (side / canvas.pt for side in canvas.box())
        self.columns, count = (
            min(int(size / CELL) + 2, _MOST) for size in (right - self.left, top - self.bottom)
        )
        self.rows = [bytearray(self.columns) for _ in range(count)]
        for stroke, outlines in zip(canvas.strokes, shapes, strict=True):
            if stroke.styles:
                self._draw(stroke, [self._on_grid(outline) for outline in outlines])

    def count(self, low: Place, high: Place) -> int:
        """How many marks are in a box, given by two corners."""
        (x0, y0), (x1, y1) = self._on_grid((low, high))
        a, b = max(round(x0), 0), max(round(x1), 0)
        rows = self.rows[max(round(y0), 0) : max(round(y1), 0)]
        return sum(sum(row[a:b]) for row in rows)

    def _on_grid(self, places):
        left, bottom = self.left, self.bottom
        return [((x - left) / CELL, (y - bottom) / CELL) for x, y in places]

    def _draw(self, stroke, outlines):
        if stroke.closed:
            outlines = [outline + outline[:1] for outline in outlines]
            if not FILLED.isdisjoint(stroke.styles):
                self._clear(outlines)
        width = STYLES[stroke.styles[0]]["linewidth"]
        for outline in outlines:
            for a, b in pairwise(outline):
                self._mark(a, b, width / CELL / 2 if width > 3 else 0)

    def _clear(self, outlines):
        """Take the marks off the inside of outlines, row by row between its edges."""
        crossings: dict = {}
        for outline in outlines:
            for (x0, y0), (x1, y1) in pairwise(outline):
                if y0 > y1:
                    x0, y0, x1, y1 = x1, y1, x0, y0
                first, end = max(math.ceil(y0 - 0.5), 0), math.ceil(y1 - 0.5)
                for row in range(first, min(end, len(self.rows))):
                    x = x0 + (row + 0.5 - y0) * (x1 - x0) / (y1 - y0)
                    crossings.setdefault(row, []).append(max(math.ceil(x - 0.5), 0))
        for row, columns in crossings.items():
            columns.sort()
            for a, b in zip(columns[::2], columns[1::2], strict=False):
                b = min(b, self.columns)
                if a < b:
                    self.rows[row][a:b] = bytes(b - a)

    def _mark(self, a, b, half):
        """Mark a line, and its edges at half its width."""
        (x, y), (dx, dy) = a, (b[0] - a[0], b[1] - a[1])
        length = math.hypot(dx, dy)
        count = math.ceil(length * CELL / STEP) + 1
        if count > 2 * _MOST:  # far beyond the page
            return
        dx, dy = dx / count, dy / count
        sides = [(x, y)]
        if half and length:
            u, v = dy * count / length * half, -dx * count / length * half
            sides += [(x + u, y + v), (x - u, y - v)]
        rows, columns = self.rows, self.columns
        for x, y in sides:
            for _ in range(count):
                if 0 <= x < columns and 0 <= y < len(rows):
                    row, column = rows[int(y)], int(x)
                    if row[column] < 255:
                        row[column] += 1
                x += dx
                y += dy
