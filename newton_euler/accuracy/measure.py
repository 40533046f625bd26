"""The time of a call, the error of a result, and the chart of error against time.

The *front* of a set of points (the Pareto front) are those that no other point beats, that is, for
every other point one on the front is cheaper and no less accurate. Errors are taken against an
exact solution or one of more digits, never against the method under test.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from operator import attrgetter
from time import perf_counter
from timeit import Timer
from typing import Any

from ..algebra.errors import ArgumentError, checked
from ..algebra.scalars import Scalar, sqrt
from ..algebra.vectors import dot3, sub3

# colours that colour-blind readers tell apart (Okabe and Ito, without their yellow), and shapes for
# those who see no colours
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
MARKERS = ("o", "s", "^", "D", "P", "X", "*", "h", "p")
# errors that differ by less than this factor count as equal: round-off is not known better
EQUAL_WITHIN = 2.0
FLOOR = 1e-17  # smaller relative errors are drawn there: a float cannot have them


@dataclass(frozen=True)
class Measured:
    """A point of a chart: ``method``, ``cost`` in seconds, relative ``error``, and ``setting`` as
    "h = 1e-3". The points of one method are joined.

    asked, calls, drift : of an integration, the tolerance, the calls of the right-hand side, and
        the largest drift of an invariant; else None

    >>> Measured("dop853", cost=2e-4, error=1e-9).cost
    0.0002
    """

    method: str
    cost: float
    error: float
    setting: str = ""
    asked: float | None = None
    calls: int | None = None
    drift: float | None = None


@checked
def timed(
    *calls: Callable[[], object],
    runs: int = 9,
    shortest: float = 2e-3,
    clock: Callable[[], float] = perf_counter,
) -> Any:
    """The seconds that one call ``f()`` takes, a float; of several functions, a tuple.

    The time is that of the fastest of ``runs`` runs. Each run has so many calls that it lasts
    ``shortest`` seconds. The functions take turns. A first call is made before and does not count:
    it may import or compile.

    clock : a function without arguments that returns the time in seconds

    >>> seconds = timed(lambda: sum(range(10)), lambda: sum(range(1000)))
    >>> len(seconds), min(seconds) > 0
    (2, True)
    """
    timers = [(Timer(f, timer=clock), _enough_calls(f, shortest, clock)) for f in calls]
    rounds = [[timer.timeit(n) / n for timer, n in timers] for _ in range(runs)]
    # the least: other work of the machine can only add to a time (measured on a busy machine: the
    # medians of two measurements differed by up to a factor of four, the minima by a tenth)
    times = tuple(map(min, zip(*rounds, strict=True)))
    return times[0] if len(calls) == 1 else times


def _enough_calls(f, shortest, clock):
    """How many calls of ``f`` last about ``shortest`` seconds, after one that does not count."""
    f()
    timer, n = Timer(f, timer=clock), 1
    while (took := timer.timeit(n)) < shortest:
        # a single call is too short to extrapolate from
        n = max(2 * n, math.ceil(n * shortest / max(took, 1e-9))) if n > 1 else 2
    return n


@checked
def relative_error(a: Sequence[Scalar], exact: Sequence[Scalar]) -> float:
    """|a - exact|/|exact| as a float, for two triples of components or Vectors of one frame.

    It is right to the last digit if the components of ``exact`` are of type mpf.

    >>> relative_error((3.0, 4.0, 0.5), (3.0, 4.0, 0.0))
    0.1
    """
    exact = tuple(exact)
    difference = sub3(tuple(a), exact)
    return float(sqrt(dot3(difference, difference)) / sqrt(dot3(exact, exact)))


def _check_cost(cost):
    if cost not in ("cost", "calls"):
        raise ArgumentError(f'the cost is "cost", the time, or "calls"; got {cost!r}')


@checked
def front(points: Sequence[Measured], cost: str = "cost") -> list[Measured]:
    """The points that no other beats, from the cheapest to the most accurate.

    Errors within a factor of two count as equal.

    cost : "cost", the time, or "calls"

    >>> coarse, fine = Measured("coarse", 1e-3, 1e-3), Measured("fine", 2e-3, 1e-9)
    >>> [p.method for p in front([fine, coarse, Measured("slow", 3e-3, 1e-9)])]
    ['coarse', 'fine']
    """
    _check_cost(cost)
    best: list[Measured] = []
    for p in sorted(points, key=attrgetter(cost, "error")):
        if not best or p.error < best[-1].error / EQUAL_WITHIN:
            best.append(p)
    return best


def marker_style(n: int) -> dict:
    """Arguments of ``plot`` for method number n; beyond the colours the markers are hollow."""
    colour = COLOURS[n % len(COLOURS)]
    filling = colour if n < len(COLOURS) else "white"
    return {"color": colour, "marker": MARKERS[n % len(MARKERS)], "mfc": filling}


def log_log(ax: Any, xlabel: str, ylabel: str) -> None:
    """Set both axes of ``ax`` to powers of ten, with a grid behind what is drawn."""
    ax.set(xscale="log", yscale="log", xlabel=xlabel, ylabel=ylabel, axisbelow=True)
    ax.grid(True, color="#dddddd", lw=0.6)


@checked
def chart(
    points: Sequence[Measured],
    ax: Any,
    floor: float = FLOOR,
    cost: str = "cost",
    order: Sequence[str] = (),
    legend: bool = True,
) -> list[Measured]:
    """The front of the points, which are drawn on the Matplotlib axes ``ax``: cost to the right,
    error upwards, the front with rings and joined by steps.

    floor : smaller errors are drawn there, with an arrow down and their value
    cost : "cost", the time, or "calls"
    order : names of methods, so that these have the same colours on several charts

    >>> from matplotlib.figure import Figure
    >>> points = [Measured("coarse", 1e-3, 1e-3), Measured("fine", 2e-3, 1e-9)]
    >>> chart(points, Figure().subplots()) == points
    True
    """
    from matplotlib.ticker import EngFormatter, LogLocator, NullFormatter

    def coordinates(points):
        return [getattr(p, cost) for p in points], [max(p.error, floor) for p in points]

    _check_cost(cost)
    if not 0 < float(floor) < 1:
        raise ArgumentError(f"the floor is an error between 0 and 1, as 1e-16; got {floor!r}")
    floor = float(floor)
    if not hasattr(ax, "add_patch"):
        raise ArgumentError(f"a chart is drawn on an Axes of matplotlib; got {ax!r}")
    log_log(ax, "cost of one evaluation", "relative error")
    for n, method in enumerate(dict.fromkeys([*order, *(p.method for p in points)])):
        own = [p for p in points if p.method == method]
        if own:
            ax.plot(*coordinates(own), ms=7, lw=0.8, label=method, **marker_style(n))
    best = coordinates(front(points, cost))
    ax.step(*best, where="post", color="#999999", lw=1.4, ls="--", zorder=1)
    ax.plot(*best, "o", ms=14, mfc="none", mec="#333333", mew=1.2, ls="none", label="front")
    costs, _ = coordinates(points)
    for x, p in zip(costs, points, strict=True):
        if p.error < floor:
            text = f"{p.error:.0e}" if p.error else "0"
            look = {"ha": "center", "fontsize": 8, "textcoords": "offset points"}
            arrow = {"arrowstyle": "<-", "color": "#333333"}
            ax.annotate(text, (x, floor), (0, -34), arrowprops=arrow, **look)
            ax.set_ylim(bottom=floor / 1000)  # room for the arrows
    # less than about two decades: powers of ten alone would leave one number on the axis or none
    if costs and max(costs) < 50 * min(costs):
        ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    ax.xaxis.set_major_formatter(EngFormatter(unit="s" if cost == "cost" else ""))
    ax.xaxis.set_minor_formatter(NullFormatter())
    if legend:
        ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, fontsize=9)
    return front(points, cost)
