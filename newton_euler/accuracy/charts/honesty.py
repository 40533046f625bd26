"""The chart of honesty: what each method promises, what it keeps, and what that costs."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median
from typing import Any

from ...algebra.late import EngFormatter, Line2D
from ..measurements.honesty import CELLS, REFUSED, MethodResult, Tally, comparable, tallies

# limits of true over asked, and of estimate over true; what lies beyond is drawn at the edge
PROMISE, ESTIMATE = (1e-6, 1e3), (1e-4, 1e5)
CAUTIOUS = 100.0  # an estimate of this many times the true error says little
WRONG, VAGUE = "#D55E00", "#777777"
HALF = 0.34  # share of a row's height that is used on each side of its middle


def draw_honesty(answers: Sequence[MethodResult], figure: Any, title: str = "") -> list[Tally]:
    """The tallies of the methods, the cheapest first, after drawing a row for each: costs, true
    errors over tolerances, estimates over true errors, counts. A row has a mark for each run, the
    coarsest tolerance at its top, and a bar at the median; what is silently wrong has a ring.
    """
    answers, relative = comparable(answers)
    found, given = tallies(answers), [a for a in answers if not a.absent]
    asked = sorted({a.asked for a in answers}, reverse=True)
    rows = _Rows({t.method: n for n, t in enumerate(found)}, asked)
    width = 12.7 + 0.08 * max(len(t.method) for t in found)
    figure.set(layout_engine="constrained", size_inches=(width, 2.3 + 0.36 * len(found)))
    figure.suptitle(title, fontsize=12)
    cost, promise, estimate, counts = figure.subplots(1, 4, sharey=True, width_ratios=(4, 6, 5, 5))
    _draw_cost(cost, rows, given, relative)
    _draw_promise(promise, rows, given, [a for a in answers if a.absent])
    _draw_estimate(estimate, rows, given, found)
    _draw_counts(counts, found, relative)
    _honesty_legend(figure, rows)
    return found


@dataclass(frozen=True)
class _Rows:
    """Rows by method, and in a row places and colours for the errors ``asked`` for."""

    numbers: dict
    asked: list

    def shade(self, rtol):
        """Its colour, darker for finer ones, so that it is one in greys as well."""
        from matplotlib import colormaps

        return colormaps["viridis"](0.88 * (1 - self._rank(rtol)))

    def place(self, answer):
        return self.numbers[answer.method] + HALF * (2 * self._rank(answer.asked) - 1)

    def _rank(self, rtol):
        return self.asked.index(rtol) / max(len(self.asked) - 1, 1)


def _draw_cost(ax, rows, given, relative):
    _panel(ax, rows, "What does it cost?")
    _draw_runs(ax, rows, [(a, a.cost) for a in given if a.cost > 0])
    ax.set_xlabel("time over the cheapest that kept its word" if relative else "time of a run")
    if not relative:
        ax.xaxis.set_major_formatter(EngFormatter(unit="s"))
    ax.set_yticks(range(len(rows.numbers)), rows.numbers)
    ax.set_ylim(len(rows.numbers) - 0.5, -0.5)


def _draw_promise(ax, rows, given, absent):
    _panel(ax, rows, "Is it as accurate as requested?")
    _draw_runs(ax, rows, [(a, a.times_asked) for a in given], PROMISE)
    _zone(ax, 1.0, 2 * PROMISE[1], WRONG, "broken")
    _draw_refused(ax, rows, absent)
    ax.set_xlabel("true error over the tolerance")


def _draw_estimate(ax, rows, given, found):
    _panel(ax, rows, "Is its error estimate true?")
    _draw_runs(ax, rows, [(a, a.effectivity) for a in given if a.estimate is not None], ESTIMATE)
    _zone(ax, ESTIMATE[0] / 2, 1.0, WRONG, "too small")
    _zone(ax, CAUTIOUS, 2 * ESTIMATE[1], VAGUE, "says little")
    for n, t in enumerate(found):
        if math.isnan(t.ratio) and not math.isnan(t.cost):
            ax.text(2.0, n, "no estimate", color=VAGUE, fontsize=9, va="center")
    ax.set_xlabel("estimated error over the true error")


def _panel(ax, rows, heading):
    ax.set_title(heading, loc="left", fontsize=10, weight="bold", pad=20)
    _stripes(ax, len(rows.numbers))


def _stripes(ax, count):
    for n in range(1, count, 2):
        ax.axhspan(n - 0.5, n + 0.5, color="black", alpha=0.04, lw=0, zorder=0)
    ax.tick_params(axis="y", length=0)


def _zone(ax, low, high, colour, words):
    ax.axvspan(low, high, color=colour, alpha=0.13, lw=0, zorder=0)
    _above(ax, math.sqrt(low * high), words, color=colour)


def _above(ax, x, words, **look):
    place = {"ha": "center", "va": "bottom", "transform": ax.get_xaxis_transform()}
    ax.text(x, 1.01, words, fontsize=9, **place, **look)


def _draw_runs(ax, rows, runs, limits=None):
    """The runs, pairs of an answer and a number, each in its row; beyond the limits at the edge."""
    ax.set(xscale="log", axisbelow=True)
    ax.grid(True, axis="x", color="#dddddd", lw=0.6)
    low, high = limits or (0.0, math.inf)
    if limits:
        ax.set_xlim(low / 2, 2 * high)
        ax.axvline(1.0, color="#333333", lw=1)
    few = len(runs) < 30 * len(rows.numbers)
    look = {"s": 24 if few else 10, "alpha": 0.9 if few else 0.6, "lw": 0, "zorder": 3}
    sides = {"<": lambda x: x < low, "o": lambda x: low <= x <= high, ">": lambda x: x > high}
    for marker, inside in sides.items():
        own = [(a, min(max(x, low), high)) for a, x in runs if inside(x)]
        _scatter(ax, rows, [a for a, _ in own], [x for _, x in own], marker=marker, **look)
    rings = [(min(max(x, low), high), rows.place(a)) for a, x in runs if a.silent]
    ring = {"ms": 8, "mfc": "none", "mec": "black", "mew": 0.9, "zorder": 4}
    ax.plot([x for x, _ in rings], [y for _, y in rings], "o", **ring)
    for method, n in rows.numbers.items():
        own = [x for a, x in runs if a.method == method]
        if own:
            middle = min(max(median(own), low), high)
            ax.plot([middle] * 2, [n - 0.42, n + 0.42], color="black", lw=1.8, zorder=5)


def _scatter(ax, rows, answers, xs, **look):
    """A mark for each answer at x, in the colour of its tolerance."""
    colours = [rows.shade(a.asked) for a in answers] or None
    ax.scatter(xs, [rows.place(a) for a in answers], c=colours, **look)


def _draw_refused(ax, rows, absent):
    """Beyond the right edge, a cross for each run without an answer, and their number."""
    low, high = PROMISE
    ax.set_xlim(low / 2, 200 * high)
    ax.set_xticks([10.0**n for n in range(-6, 4, 2)])
    ax.axvline(2 * high, color="#333333", lw=0.8)
    _above(ax, 20 * high, "refused" if all(a.absent == REFUSED for a in absent) else "no answer")
    _scatter(ax, rows, absent, [7 * high] * len(absent), marker="x", s=14, lw=1)
    for method, n in rows.numbers.items():
        count = sum(a.method == method for a in absent)
        ax.text(130 * high, n, count or "", fontsize=9, ha="right", va="center")


def _draw_counts(ax, found, relative):
    _stripes(ax, len(found))
    ax.set_axis_off()
    heads = "runs", "met %", "covers %", "est/true", "silent", "cost"
    for x, head in zip((0.07, 0.23, 0.44, 0.65, 0.80, 1.0), heads, strict=True):
        ax.text(x, 1.01, head, fontsize=9, ha="right", va="bottom", transform=ax.transAxes)
        for n, t in enumerate(found):
            place = {"ha": "right", "va": "center", "transform": ax.get_yaxis_transform()}
            ax.text(x, n, CELLS[head](t, relative) or "", fontsize=9, **place)


def _honesty_legend(figure, rows):
    silent = "silently wrong: error over 10 times tolerance and estimate"
    looks = [("o", f"{x:.0e}".replace("e-0", "e-"), {"color": rows.shade(x)}) for x in rows.asked]
    looks += [("|", "median", {"color": "black", "ms": 12, "mew": 2})]
    looks += [("o", silent, {"mfc": "none", "mec": "black", "ms": 8})]
    entries = [Line2D([], [], ls="none", marker=m, label=text, **look) for m, text, look in looks]
    place = {"loc": "outside lower center", "ncols": len(entries), "frameon": False}
    look = {"fontsize": 9, "columnspacing": 1.2, "handletextpad": 0.2}
    figure.legend(handles=entries, title="tolerance", **place, **look)
