"""The axes of a chart: cost to the right, error upwards, and the marks that all charts share."""

from collections.abc import Sequence
from typing import Any

from ...algebra.errors import ArgumentError, checked
from ..measurements.measure import Cost, Measured, Points, fronts

# colours that colour-blind readers can distinguish (Okabe and Ito, without their yellow), and
# shapes for those who see no colours
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
MARKERS = ("o", "s", "^", "D", "P", "X", "*", "h", "p")
GREY, INK = "#999999", "#333333"
# smaller relative errors, which a float cannot have, are drawn there with their value
FLOOR = 1e-17
USELESS = 0.1  # a relative error from which no digit is right: such a point is not a choice
DASHES = ("--", ":", "-.")  # line styles of the fronts


def marker_style(n: int) -> dict:
    """Arguments of ``plot`` for method number n; beyond the colours the markers are hollow."""
    colour = COLOURS[n % len(COLOURS)]
    filling = colour if n < len(COLOURS) else "white"
    return {"color": colour, "marker": MARKERS[n % len(MARKERS)], "mfc": filling}


def log_log(ax: Any, xlabel: str, ylabel: str) -> None:
    """Set both axes of ``ax`` to powers of ten, with a grid behind what is drawn."""
    ax.set(xscale="log", yscale="log", xlabel=xlabel, ylabel=ylabel, axisbelow=True)
    ax.grid(True, color="#dddddd", lw=0.6)
    ax.minorticks_off()  # they take a third of the time of drawing


def mark_better(ax: Any) -> None:
    """Write "better" in the lower left corner, with an arrow into it."""
    arrow = {"arrowstyle": "->", "color": "#666666"}
    place = {"xycoords": "axes fraction", "textcoords": "axes fraction"}
    look = {"color": "#666666", "fontsize": 9, "style": "italic"}
    ax.annotate("better", (0.012, 0.015), (0.06, 0.06), arrowprops=arrow, **place, **look)


def time_axis(ax: Any, costs: Sequence[float], unit: str = "s") -> None:
    """Numbers with the prefixes of the unit along the x axis of ``ax``, enough of them."""
    from matplotlib.ticker import EngFormatter, LogLocator

    # less than about two decades: powers of ten alone would leave one number on the axis or none
    if costs and max(costs) < 50 * min(costs):
        ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    ax.xaxis.set_major_formatter(EngFormatter(unit=unit))


@checked
def chart(
    points: Points, ax: Any, cost: Cost = "cost", order: Sequence[str] = (), legend: bool = True
) -> list[Measured]:
    """The fronts of the points, which are drawn on the Matplotlib axes ``ax``: cost to the right,
    error upwards. Each family has a front, with rings and steps, of points that have a right digit;
    of times, those that are on the front of every repeat.
    A band goes from the least to the largest time of its repeats; a grey bar is the time to prepare
    the first run.

    cost : "cost", the time, or "calls"
    order : names of methods, to give them the same colours on several charts

    >>> from matplotlib.figure import Figure
    >>> points = [Measured("coarse", 1e-3, 1e-3), Measured("fine", 2e-3, 1e-9)]
    >>> chart(points, Figure().subplots()) == points
    True
    """
    if not hasattr(ax, "add_patch"):
        raise ArgumentError(f"a chart is drawn on an Axes of matplotlib; got {ax!r}")
    log_log(ax, "cost of one evaluation", "relative error")
    drawing = _Drawing(ax, cost)
    drawing.methods(points, order)
    if cost == "cost":
        drawing.times(points)
    best = fronts([p for p in points if p.error < USELESS], cost)
    drawing.fronts(best)
    drawing.below_the_floor(points)
    ax.set_ylim(bottom=ax.get_ylim()[0] / 30)  # room for "better"
    mark_better(ax)
    time_axis(ax, [getattr(p, cost) for p in points], "s" if cost == "cost" else "")
    if legend:
        ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, fontsize=9)
    return [p for family in best.values() for p in family]


class _Drawing:
    def __init__(self, ax, cost):
        self.ax, self.cost = ax, cost

    def places(self, points):
        return [getattr(p, self.cost) for p in points], [max(p.error, FLOOR) for p in points]

    def methods(self, points, order):
        """Draw a line of marks for each method, in ``order`` first, so that colours stay."""
        for n, method in enumerate(dict.fromkeys([*order, *(p.method for p in points)])):
            own = [p for p in points if p.method == method]
            if own:
                self.ax.plot(*self.places(own), ms=7, lw=0.8, label=method, **marker_style(n))

    def times(self, points):
        """A band over the times of the repeats of a run, whose median is the point, and a bar to
        the time of the first run, where it can be seen.
        """
        colours = {line.get_label(): line.get_color() for line in self.ax.lines}
        bar = {"color": GREY, "lw": 1.2, "marker": "|", "ms": 9, "markevery": [1], "zorder": 1}
        bar["label"] = "first run, with preparation"
        for p in points:
            height = [max(p.error, FLOOR)] * 2
            if p.repeats:
                band = {"color": colours[p.method], "lw": 4, "alpha": 0.35, "zorder": 1}
                self.ax.plot([min(p.repeats), max(p.repeats)], height, **band)
            if p.prepared > 0.2 * p.cost:
                self.ax.plot([p.cost, p.cost + p.prepared], height, **bar)
                bar["label"] = "_again"  # one entry of the legend is enough

    def fronts(self, found):
        """Draw the front of each family: the least cost at which an error is reached."""
        for n, (family, best) in enumerate(found.items()):
            x, y = self.places(best)
            dashes = DASHES[n % len(DASHES)]
            self.ax.step(x, y, where="post", color=GREY, lw=1.4, ls=dashes, zorder=1)
            label = f"front of the {family}" if family else "front"
            rings = {"ms": 14 + 3 * n, "mfc": "none", "mec": INK if n == 0 else GREY, "mew": 1.2}
            self.ax.plot(x, y, "o", ls="none", label=label, **rings)

    def below_the_floor(self, points):
        """Write the error at the points that lie below what the axis shows."""
        for x, p in zip(self.places(points)[0], points, strict=True):
            if p.error < FLOOR:
                text = f"{p.error:.0e}" if p.error else "0"
                look = {"ha": "center", "fontsize": 8, "textcoords": "offset points"}
                arrow = {"arrowstyle": "<-", "color": INK}
                self.ax.annotate(text, (x, FLOOR), (0, -34), arrowprops=arrow, **look)
                self.ax.set_ylim(bottom=FLOOR / 1000)  # room for the arrows
