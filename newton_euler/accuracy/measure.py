"""What all charts of accuracy share: the time of a call, the error of a result, and their chart.

The *front* of a set of points (the Pareto front) are those that no other beats: for every other
point one is cheaper and no less accurate. The reference of an error is an exact solution or one of
more digits, never the method under test.
"""

import math
from dataclasses import dataclass
from operator import attrgetter
from timeit import Timer

from ..algebra.scalars import sqrt
from ..algebra.vectors import dot3, sub3

# colours that colour-blind readers tell apart (Okabe and Ito, without their yellow), and shapes for
# those who see none
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
MARKERS = ("o", "s", "^", "D", "P", "X", "*", "h", "p")
# errors that differ by less than this factor count as equal: round-off is not known better
EQUAL_WITHIN = 2.0


@dataclass(frozen=True)
class Measured:
    """A point of a chart: ``method`` (points of one method are joined), ``cost`` in seconds,
    relative ``error``, and the ``setting``, as "h = 1e-3".

    asked, calls, drift : of an integration, the tolerance, the calls of the right-hand side, and
        the largest drift of an invariant; else None
    """

    method: str
    cost: float
    error: float
    setting: str = ""
    asked: float | None = None
    calls: int | None = None
    drift: float | None = None


def timed(*calls, runs=9, shortest=2e-3):
    """The time in seconds that one call ``f()`` takes; of several functions, a tuple of their
    times.

    It is the fastest of ``runs`` runs, each of so many calls that it lasts ``shortest`` seconds,
    since other work of the machine can only add to a time (on a busy machine medians of two
    measurements differed by up to a factor of four, minima by a tenth). The functions take turns.
    One call is made before and does not count: it may import or compile.

    >>> fast, slow = timed(lambda: sum(range(10)), lambda: sum(range(1000)))
    >>> 0 < fast < slow
    True
    """
    timers = [(Timer(f), _enough_calls(f, shortest)) for f in calls]
    rounds = [[timer.timeit(n) / n for timer, n in timers] for _ in range(runs)]
    times = tuple(map(min, zip(*rounds, strict=True)))
    return times[0] if len(calls) == 1 else times


def _enough_calls(f, shortest):
    """How many calls of ``f`` last about ``shortest`` seconds, after one that does not count."""
    f()
    timer, n = Timer(f), 1
    while (took := timer.timeit(n)) < shortest:
        n = max(2 * n, math.ceil(n * shortest / max(took, 1e-9))) if n > 1 else 2
    return n


def relative_error(a, exact):
    """|a - exact|/|exact| as a float, for two triples of components or Vectors of one frame; right to the last digit if ``exact`` is of mpf.

    >>> relative_error((3.0, 4.0, 0.5), (3.0, 4.0, 0.0))
    0.1
    """
    exact = tuple(exact)
    difference = sub3(tuple(a), exact)
    return float(sqrt(dot3(difference, difference)) / sqrt(dot3(exact, exact)))


def front(points, cost="cost"):
    """The points that no other beats, from the cheapest to the most accurate. Errors within a
    factor of two count as equal.

    cost : "cost", the time, or "calls"

    >>> fine, coarse, slow = Measured("fine", 2e-3, 1e-9), Measured("coarse", 1e-3, 1e-3), Measured("slow", 3e-3, 1e-9)
    >>> [p.method for p in front([fine, coarse, slow])]
    ['coarse', 'fine']
    """
    out = []
    for p in sorted(points, key=attrgetter(cost, "error")):
        if not out or p.error < out[-1].error / EQUAL_WITHIN:
            out.append(p)
    return out


def marker_style(n):
    """Arguments of ``plot`` for method number n; beyond the colours the markers are hollow."""
    colour = COLOURS[n % len(COLOURS)]
    return {
        "color": colour,
        "marker": MARKERS[n % len(MARKERS)],
        "mfc": colour if n < len(COLOURS) else "white",
    }


def log_log(ax, xlabel, ylabel):
    """Both axes of ``ax`` in powers of ten, with a grid behind what is drawn."""
    ax.set(xscale="log", yscale="log", xlabel=xlabel, ylabel=ylabel, axisbelow=True)
    ax.grid(True, color="#dddddd", lw=0.6)


def chart(points, ax, floor=1e-17, cost="cost", order=(), legend=True):
    """The front of the points, which are drawn on ``ax``: cost to the right, error upwards, the
    front with rings and joined by steps.

    floor : smaller errors, which a float cannot have, are drawn there with an arrow down
    cost : "cost", the time, or "calls"; order : names of methods, so that these have the same
        colours on several charts
    """
    from matplotlib.ticker import EngFormatter, LogLocator, NullFormatter

    def coordinates(points):
        return [getattr(p, cost) for p in points], [max(p.error, floor) for p in points]

    log_log(ax, "cost of one evaluation", "relative error")
    for n, method in enumerate(dict.fromkeys([*order, *(p.method for p in points)])):
        own = [p for p in points if p.method == method]
        if own:
            ax.plot(*coordinates(own), ms=7, lw=0.8, label=method, **marker_style(n))
    best = front(points, cost)
    ax.step(*coordinates(best), where="post", color="#999999", lw=1.4, ls="--", zorder=1)
    ax.plot(
        *coordinates(best), "o", ms=14, mfc="none", mec="#333333", mew=1.2, ls="none", label="front"
    )
    costs, _ = coordinates(points)
    for x, p in zip(costs, points, strict=True):
        if p.error < floor:
            text, arrow = (
                f"{p.error:.0e}" if p.error else "0",
                {"arrowstyle": "<-", "color": "#333333"},
            )
            ax.annotate(
                text,
                (x, floor),
                (0, -34),
                textcoords="offset points",
                ha="center",
                fontsize=8,
                arrowprops=arrow,
            )
            ax.set_ylim(bottom=floor / 1000)
    if costs and max(costs) < 50 * min(costs):
        ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    ax.xaxis.set_major_formatter(EngFormatter(unit="s" if cost == "cost" else ""))
    ax.xaxis.set_minor_formatter(NullFormatter())
    if legend:
        ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, fontsize=9)
    return best
