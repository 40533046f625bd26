"""The charts of the maps of parameter space, and their captions.

Islands are parts of a choice apart from its largest part. Where times decide they are measured
again, and smoothed if they stay small; elsewhere they are explained by a closer look.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from textwrap import fill
from typing import Any, TypeAlias

from ...algebra.late import np
from ..measurements.regime_maps import Map
from .axes import COLOURS
from .words import two_digits

SMALLEST = 0.03  # share of the map; a smaller region is named in the legend only
WIDE = 18  # letters in a line of a name
SPECK = 4  # cells; an island of times that is no larger is taken for noise
Cells: TypeAlias = tuple[tuple[int, int], ...]
TOUCHING = [[1] * 3] * 3  # cells that touch at a corner belong together
CLOSER = 40  # looks at the height of three cells


def draw_choices(chart: Map, found: "np.ndarray", ax: Any) -> None:
    """Draw a map on ``ax``: regions with their names, a legend of colours and borders."""
    handles = [*_draw_cells(chart, found, ax), *_draw_borders(chart, found, ax)]
    for choice in chart.choices:
        _name_region(chart, found, choice, ax)
    x, y = chart.x.edges(found.shape[1]), chart.y.edges(found.shape[0])
    ax.set(xlabel=chart.x.label, xscale=chart.x.scale, xlim=x[[0, -1]], title=chart.title)
    ax.set(ylabel=chart.y.label, yscale=chart.y.scale, ylim=y[[0, -1]])
    place = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.0)}
    ax.legend(handles=handles, frameon=False, fontsize=9, **place)


def _draw_cells(chart, found, ax):
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    numbers, top_number = np.vectorize(chart.choices.index)(found), len(chart.choices) - 0.5
    colours = dict(zip(chart.choices, COLOURS, strict=False))
    x, y = chart.x.edges(found.shape[1]), chart.y.edges(found.shape[0])
    style = {"cmap": ListedColormap(colours.values()), "vmin": -0.5, "vmax": top_number}
    ax.pcolormesh(x, y, numbers, alpha=0.75, linewidth=0, rasterized=True, **style)
    shown = [(choice, colour) for choice, colour in colours.items() if (found == choice).any()]
    return [Patch(color=colour, alpha=0.75, label=choice) for choice, colour in shown]


def _draw_borders(chart, found, ax):
    y, points = chart.y.edges(found.shape[0]), chart.x.centres(800)
    for curve, dashes in zip(chart.curves, ("-", "--"), strict=False):
        xs, ys = (points, curve.y(points)) if curve.y else ([curve.x] * 2, y[[0, -1]])
        yield from ax.plot(xs, ys, color="black", lw=1.8, ls=dashes, label=curve.label)


def _name_region(chart, found, choice, ax):
    """Write the choice into the widest place of its largest part, if that is large enough."""
    from scipy.ndimage import distance_transform_edt

    largest = parts(found, choice)[:1]
    if not largest or len(largest[0]) < SMALLEST * found.size:
        return
    inside = np.zeros(np.add(found.shape, 2))  # the frame of the map is a border as well
    inside[tuple(np.array(largest[0]).T + 1)] = 1
    row, column = np.unravel_index(distance_transform_edt(inside).argmax(), inside.shape)
    x, y = chart.x.centres(found.shape[1])[column - 1], chart.y.centres(found.shape[0])[row - 1]
    box = {"boxstyle": "round,pad=0.2", "fc": "white", "ec": "none", "alpha": 0.8}
    words = fill(choice, WIDE)
    side = "left" if column < 4 else "right" if column > found.shape[1] - 3 else "center"
    ax.text(x, y, words, fontsize=9, ha=side, va="center", bbox=box, gid="region")


def map_table(chart: Map, found: "np.ndarray") -> str:
    """The share of the map of each choice, as a table."""
    rows = [f"  {choice:44} {share:6.1%} of the map" for choice, share in _shares(chart, found)]
    return "\n".join([f"  {chart.words}", *rows])


def _shares(chart, found):
    shares = [(choice, float((found == choice).mean())) for choice in chart.choices]
    return [(choice, share) for choice, share in shares if share]


def map_caption(chart: Map, found: "np.ndarray", smoothed: int = 0) -> str:
    """What the map shows: the share of each choice, what lies along its lower and upper edges, its
    islands, and how many cells were ``smoothed``.
    """
    shares = "; ".join(f"{choice}: {_percent(share)}" for choice, share in _shares(chart, found))
    edges = {"lowest": found[0], "highest": found[-1]}
    met = [_along(chart, side, row) for side, row in edges.items()]
    text = [chart.words, f"Shares of the map: {shares}.", *met]
    if smoothed:
        text.append(f"{smoothed} isolated cells were noise of the times: they vanished when they")
        text.append("were measured again, or took the choice of their neighbours.")
    return " ".join([*text, *(() if chart.timed else island_sentences(chart, found))])


def _percent(share):
    return f"{100 * share:.0f} %" if share > 0.005 else "less than 1 %"


def _along(chart, side, row):
    edges, along = chart.x.edges(len(row)), [row[0]]
    for n in range(1, len(row)):
        if row[n] != row[n - 1]:
            along.append(f"from {two_digits(float(edges[n]))} on {row[n]}")
    letter = chart.y.label.partition(",")[0]
    return f"At the {side} {letter}, from left to right: {'; '.join(along)}."


# -- islands


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
