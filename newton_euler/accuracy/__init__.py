"""Speed charted against accuracy: measure what a method costs and how far it is off, and show which one to choose.

The *front* of a set of methods are those that no other beats: every other one has a rival that is cheaper and no less accurate. The reference of
an error is an exact solution or one of more digits, never the method under test.

``python -m newton_euler.accuracy NAME`` measures a scene, the models of one, or a comparison then and there, and draws a chart; ``--help`` says more.
Here is what all charts share. :mod:`.precision` measures methods on a scene of :mod:`~.scenes` against :mod:`.reference`, :mod:`.comparisons` the
textbook's ways (:mod:`.rivals`) where nothing moves; :mod:`.charts` and :mod:`.maps` draw.
"""

import math
from dataclasses import dataclass
from timeit import Timer

from ..scalars import sqrt
from ..vectors import dot3, sub3

# colours that colour-blind readers tell apart (Okabe and Ito, without their yellow), and shapes for those who see none
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000")
MARKERS = ("o", "s", "^", "D", "P", "X", "*", "h", "p")
SAME = 2.0  # errors that differ by less than this factor are equal: round-off is no better known


@dataclass(frozen=True)
class Measured:
    """A point of a chart: ``method`` (points of one method are joined), ``cost`` in seconds, relative ``error``, what was set, as "h = 1e-3".

    asked, calls, drift : of an integration, the error asked for, the calls of the right-hand side, and the worst drift of an invariant; else None
    """

    method: str
    cost: float
    error: float
    setting: str = ""
    asked: float | None = None
    calls: int | None = None
    drift: float | None = None


def timed(*calls, runs=9, shortest=2e-3):
    """The time in seconds that one call ``f()`` takes; of several functions, a tuple of their times.

    The fastest of ``runs`` runs, each of so many calls that it lasts ``shortest`` seconds: what else the machine does can only add to
    it (on a busy machine medians of two measurements differed by up to a factor of four, these by a tenth). The functions take turns. One
    call is made before and does not count: it may import or compile.

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
    """|a - exact|/|exact| for two triples of components or Vectors of one frame, as a float; exact to the last digit if ``exact`` is of mpf.

    >>> relative_error((3.0, 4.0, 0.5), (3.0, 4.0, 0.0))
    0.1
    """
    a, exact = tuple(a), tuple(exact)
    difference = sub3(a, exact)
    return float(sqrt(dot3(difference, difference)) / sqrt(dot3(exact, exact)))


def front(points, cost="cost"):
    """The points that no other beats, from the cheapest to the most accurate. Errors within a factor of two count as equal.

    cost : "cost", the time, or "calls"

    >>> fine, coarse, slow = Measured("fine", 2e-3, 1e-9), Measured("coarse", 1e-3, 1e-3), Measured("slow", 3e-3, 1e-9)
    >>> [p.method for p in front([fine, coarse, slow])]
    ['coarse', 'fine']
    """
    out = []
    for p in sorted(points, key=lambda p: (getattr(p, cost), p.error)):
        if not out or p.error < out[-1].error / SAME:
            out.append(p)
    return out


def look(n):
    """How the method number n is drawn: arguments of ``plot``; beyond the colours the marks are hollow."""
    colour = COLOURS[n % len(COLOURS)]
    return {"color": colour, "marker": MARKERS[n % len(MARKERS)], "mfc": colour if n < len(COLOURS) else "white"}


def chart(points, ax, floor=1e-17, cost="cost", order=(), legend=True):
    """The points on ``ax``, cost to the right and error upwards, both in powers of ten; the front is ringed and joined by steps.

    floor : smaller errors, which a float cannot have, are drawn there with an arrow down
    cost : "cost", the time, or "calls"; order : names of methods, which are to look the same on several charts
    Returns the front.
    """
    from matplotlib.ticker import EngFormatter, LogLocator, NullFormatter

    best = front(points, cost)
    height = {p: max(p.error, floor) for p in points}
    methods = dict.fromkeys([*order, *(p.method for p in points)])
    for n, method in enumerate(methods):
        own = [p for p in points if p.method == method]
        if own:
            ax.plot([getattr(p, cost) for p in own], [height[p] for p in own], ms=7, lw=0.8, label=method, **look(n))
    across, up = [getattr(p, cost) for p in best], [height[p] for p in best]
    ax.step(across, up, where="post", color="#999999", lw=1.4, ls="--", zorder=1)
    ax.plot(across, up, "o", ms=14, mfc="none", mec="#333333", mew=1.2, ls="none", label="front")
    ax.set(xscale="log", yscale="log", xlabel="cost of one evaluation", ylabel="relative error")
    for p in points:
        if p.error < floor:
            told, arrow = f"{p.error:.0e}" if p.error else "0", {"arrowstyle": "<-", "color": "#333333"}
            ax.annotate(told, (getattr(p, cost), floor), (0, -34), textcoords="offset points", ha="center", fontsize=8, arrowprops=arrow)
            ax.set_ylim(bottom=floor / 1000)
    costs = [getattr(p, cost) for p in points]
    if costs and max(costs) < 50 * min(costs):
        ax.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    ax.xaxis.set_major_formatter(EngFormatter(unit="s" if cost == "cost" else ""))
    ax.xaxis.set_minor_formatter(NullFormatter())
    ax.grid(True, color="#dddddd", lw=0.6)
    ax.set_axisbelow(True)
    if legend:
        ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, fontsize=9)
    return best
