"""Speed charted against accuracy: measure what a method costs and how far it is off, and show which one to choose.

The *front* of a set of methods are those that no other beats: every other one has a rival that is cheaper and no less accurate. The reference of
an error is an exact solution or one of more digits, never the method under test.
"""

import statistics
from dataclasses import dataclass
from functools import partial
from timeit import Timer

from .scalars import sqrt
from .vectors import dot3, sub3

# colours that colour-blind readers tell apart (Okabe and Ito, without their yellow), and shapes for those who see none
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
MARKERS = ("o", "s", "^", "D", "P", "X", "*", "h", "p")
SAME = 2.0  # errors that differ by less than this factor are equal: round-off is no better known


@dataclass(frozen=True)
class Measured:
    """One point of a chart: ``method`` (points of one method are joined), ``cost`` in seconds, relative ``error``, and what was set, as "h = 1e-3"."""

    method: str
    cost: float
    error: float
    setting: str = ""


def timed(f, *args, runs=7, shortest=2e-3):
    """The time in seconds that one call ``f(*args)`` takes: the median of ``runs`` runs, each of so many calls that it lasts ``shortest`` seconds.

    One call is made before and does not count, since it may import or compile.

    >>> 0 < timed(abs, -1.0) < 1e-3
    True
    """
    f(*args)
    timer, calls = Timer(partial(f, *args)), 1
    while (took := timer.timeit(calls)) < shortest:
        calls = max(2 * calls, int(1.2 * calls * shortest / max(took, 1e-9))) if took < shortest / 2 else 2 * calls
    return statistics.median(timer.timeit(calls) / calls for _ in range(runs))


def relative_error(a, exact):
    """|a - exact|/|exact| for two triples of components or Vectors of one frame, as a float; exact to the last digit if ``exact`` is of mpf.

    >>> relative_error((3.0, 4.0, 0.5), (3.0, 4.0, 0.0))
    0.1
    """
    a, exact = tuple(a), tuple(exact)
    difference = sub3(a, exact)
    return float(sqrt(dot3(difference, difference)) / sqrt(dot3(exact, exact)))


def front(points):
    """The points that no other beats, from the cheapest to the most accurate. Errors within a factor of two count as equal.

    >>> fine, coarse, slow = Measured("fine", 2e-3, 1e-9), Measured("coarse", 1e-3, 1e-3), Measured("slow", 3e-3, 1e-9)
    >>> [p.method for p in front([fine, coarse, slow])]
    ['coarse', 'fine']
    """
    out = []
    for p in sorted(points, key=lambda p: (p.cost, p.error)):
        if not out or p.error < out[-1].error / SAME:
            out.append(p)
    return out


def chart(points, ax, floor=1e-17):
    """The points on ``ax``, cost to the right and error upwards, both in powers of ten; the front is ringed and joined by steps.

    floor : smaller errors, which a float cannot have, are drawn there with an arrow down
    Returns the front.
    """
    from matplotlib.ticker import EngFormatter

    best = front(points)
    height = {p: max(p.error, floor) for p in points}
    for n, method in enumerate(dict.fromkeys(p.method for p in points)):
        own = [p for p in points if p.method == method]
        colour, marker = COLOURS[n % len(COLOURS)], MARKERS[n % len(MARKERS)]
        ax.plot([p.cost for p in own], [height[p] for p in own], marker=marker, ms=7, lw=0.8, color=colour, label=method)
    ax.step([p.cost for p in best], [height[p] for p in best], where="post", color="#999999", lw=1.4, ls="--", zorder=1)
    ax.plot([p.cost for p in best], [height[p] for p in best], "o", ms=14, mfc="none", mec="#333333", mew=1.2, ls="none", label="front")
    for p in points:
        if p.error < floor:
            ax.annotate("", (p.cost, floor / 30), (p.cost, floor), arrowprops={"arrowstyle": "->", "color": "#333333"})
    ax.set(xscale="log", yscale="log", xlabel="cost of one evaluation", ylabel="relative error")
    ax.xaxis.set_major_formatter(EngFormatter(unit="s"))
    ax.grid(True, color="#dddddd", lw=0.6)
    ax.set_axisbelow(True)
    ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, fontsize=9)
    return best
