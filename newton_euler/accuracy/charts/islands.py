"""Islands of a map: parts of a choice apart from its largest part. Where times decide they are
measured again, and smoothed if they stay small; elsewhere they are explained by a closer look.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TypeAlias

from ...algebra.late import np
from ..measurements.regime_maps import Map
from .words import two_digits

SPECK = 4  # cells; an island of times that is no larger is taken for noise
Cells: TypeAlias = tuple[tuple[int, int], ...]
TOUCHING = [[1] * 3] * 3  # cells that touch at a corner belong together
CLOSER = 40  # looks at the height of three cells


@dataclass(frozen=True)
class Island:
    """A part of the map with one ``choice``; its ``cells`` are pairs (row, column)."""

    choice: str
    cells: Cells


def parts(found: "np.ndarray", choice: str) -> list[Cells]:
    """The connected parts of a choice, the largest first, each a tuple of cells (row, column)."""
    from scipy.ndimage import label

    numbered, count = label(found == choice, TOUCHING)
    places = [np.argwhere(numbered == n + 1).tolist() for n in range(count)]
    cells = [tuple((row, column) for row, column in own) for own in places]
    return sorted(cells, key=len, reverse=True)


def islands(found: "np.ndarray") -> list[Island]:
    """All :class:`Island` of a map."""
    names = dict.fromkeys(found.ravel())
    return [Island(name, cells) for name in names for cells in parts(found, name)[1:]]


def without_noise(chart: Map, found: "np.ndarray") -> tuple["np.ndarray", int]:
    """The choices without islands that are noise of the times, and how many cells changed. The
    columns of islands are measured again; small islands that stay go to their neighbours.
    """
    better = found.copy()
    columns = {m for island in islands(found) for _, m in island.cells}
    up, across = found.shape
    xs, ys = chart.x.centres(across).tolist(), chart.y.centres(up).tolist()
    again = {m: list(chart.column(xs[m], ys)) for m in sorted(columns)}
    for island in islands(found):
        for n, m in island.cells:
            better[n, m] = again[m][n]
    for island in islands(better):
        if len(island.cells) <= SPECK:
            _give_to_neighbours(better, island)
    return better, int((better != found).sum())


def _give_to_neighbours(found, island):
    up, across = found.shape
    around = {
        (n + i, m + j)
        for n, m in island.cells
        for i, j in ((1, 0), (-1, 0), (0, 1), (0, -1))
        if 0 <= n + i < up and 0 <= m + j < across
    }
    most = Counter(found[cell] for cell in sorted(around.difference(island.cells))).most_common(1)
    for cell in island.cells:
        found[cell] = most[0][0]


def island_sentences(chart: Map, found: "np.ndarray", most: int = 2) -> Iterator[str]:
    """A sentence for each of the first islands, from a closer look at the column of its middle."""
    every = islands(found)
    yield from (_explained(chart, found, island) for island in every[:most])
    if len(every) > most:
        yield f"There are {len(every) - most} more islands."


def _explained(chart, found, island):
    n, m = island.cells[len(island.cells) // 2]
    low, high = strip(chart, found, island.choice, n, m)
    edges = chart.y.edges(found.shape[0])
    x, y = (axis.label.partition(",")[0] for axis in (chart.x, chart.y))
    place = f"{x} = {two_digits(float(chart.x.centres(found.shape[1])[m]))}"
    text = f'The island of "{island.choice}" at {place} lies between {two_digits(low)} and '
    text += f"{two_digits(high)} of {y}: "
    if _height(chart, low, high) < _height(chart, float(edges[n]), float(edges[n + 1])):
        return text + "a strip thinner than a cell, which some columns miss."
    return text + "a region of its own."


def strip(chart: Map, found: "np.ndarray", choice: str, n: int, m: int) -> tuple[float, float]:
    """From where to where the choice holds in column ``m`` around row ``n``, looked at closely."""
    up, across = found.shape
    edges = chart.y.edges(up)
    low, high = float(edges[max(n - 1, 0)]), float(edges[min(n + 2, up)])
    closer = replace(chart.y, low=low, high=high).edges(CLOSER - 1)
    ys = np.union1d(closer, chart.y.centres(up)[n])
    holds = np.array(list(chart.column(float(chart.x.centres(across)[m]), ys.tolist()))) == choice
    return float(ys[holds].min()), float(ys[holds].max())


def _height(chart, low, high):
    return np.log(high / low) if chart.y.scale == "log" else high - low
