"""The charts of the maps of parameter space: regions with their names, the borders of theory, and
captions.
"""

import numpy as np

from ...regime_maps import MAPS
from ..axes import COLOURS
from ..words import listed, number

SMALLEST = 0.02  # of the map: a smaller region is named in the legend only


def draw_map(name, ax, resolution=None, progress=lambda fraction: None):
    """The choices of the map of this name, measured and drawn on ``ax`` with a legend of the
    colours and of the theoretical borders.
    """
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    chart = MAPS[name]
    found = chart.measure(resolution, progress)
    numbers, top_number = np.vectorize(chart.choices.index)(found), len(chart.choices) - 0.5
    colours = dict(zip(chart.choices, COLOURS, strict=False))
    x, y = chart.x.edges(found.shape[1]), chart.y.edges(found.shape[0])
    style = {"cmap": ListedColormap(colours.values()), "vmin": -0.5, "vmax": top_number}
    ax.pcolormesh(x, y, numbers, alpha=0.75, linewidth=0, rasterized=True, **style)
    shown = [(choice, colour) for choice, colour in colours.items() if (found == choice).any()]
    handles = [Patch(color=colour, alpha=0.75, label=choice) for choice, colour in shown]
    points = chart.x.centres(800)
    for curve, dashes in zip(chart.curves, ("-", "--"), strict=False):
        xs, ys = (points, curve.y(points)) if curve.y else ([curve.x] * 2, y[[0, -1]])
        handles += ax.plot(xs, ys, color="black", lw=1.8, ls=dashes, label=curve.label)
    ax.set(xlabel=chart.x.label, xscale=chart.x.scale, xlim=x[[0, -1]], title=chart.title)
    ax.set(ylabel=chart.y.label, yscale=chart.y.scale, ylim=y[[0, -1]])
    place = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.0)}
    ax.legend(handles=handles, frameon=False, fontsize=9, **place)
    return found


def map_table(chart, found):
    """The share of the map of each choice, as a table."""
    rows = [f"  {choice:44} {share:6.1%} of the map" for choice, share in _shares(chart, found)]
    return "\n".join([f"  {chart.words}", *rows])


def _shares(chart, found):
    shares = [(choice, float((found == choice).mean())) for choice in chart.choices]
    return [(choice, share) for choice, share in shares if share]


def map_caption(chart, found):
    """What the map shows: the share of each choice, and what is met along its lower and upper
    edges.
    """
    shares = listed(f"{choice} {100 * share:.0f} %" for choice, share in _shares(chart, found))
    edges = {"lowest": found[0], "highest": found[-1]}
    met = [_along(chart, side, row) for side, row in edges.items()]
    return " ".join([chart.words, f"Shares of the map: {shares}.", *met])


def _along(chart, side, row):
    edges, parts = chart.x.edges(len(row)), [row[0]]
    for n in range(1, len(row)):
        if row[n] != row[n - 1]:
            parts.append(f"from {number(float(edges[n]))} on {row[n]}")
    letter = chart.y.label.partition(",")[0]
    return f"At the {side} {letter}, from left to right: {', '.join(parts)}."
