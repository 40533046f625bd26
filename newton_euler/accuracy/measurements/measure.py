"""The time of a call, the error of a result, and the (Pareto) *front* of error against time: every
point off the front has one on it that is cheaper and no less accurate.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from operator import attrgetter
from statistics import median
from time import perf_counter
from timeit import Timer
from typing import Any, Literal, TypeAlias, TypeVar

from ...algebra.errors import checked
from ...algebra.scalars import Scalar, sqrt
from ...algebra.vectors import dot3, sub3

# errors that differ by less than this factor count as equal: round-off is not known better
EQUAL_WITHIN = 2.0
ROUND_OFF = 2.0**-52  # smaller relative errors are luck
NEAR = 16 * ROUND_OFF  # right to round-off after some steps of arithmetic: more so is luck, too
EQUAL_COST = 1.2  # counts of operations that differ by less count as equal
# times that differ by less are "about the same" in words: so they vary on a busy machine
ALIKE = 3.0
Progress: TypeAlias = Callable[[float, str], object]  # is passed the share done, and what is next
Call: TypeAlias = Callable[[], object]
Clock: TypeAlias = Callable[[], float]
Cost: TypeAlias = Literal["cost", "calls"]  # the time, or the calls of the right-hand side


def silent(fraction: float, words: str = "") -> None:
    """A :data:`Progress` that shows nothing."""


@dataclass(frozen=True)
class Measured:
    """A point of a chart: ``method``, ``cost`` in seconds, the median of the ``repeats`` of a run,
    relative ``error``, and ``setting`` as "h = 1e-3". The points of one method are joined.

    asked, calls, drift : of an integration, the tolerance, the calls of the right-hand side, and
        the largest drift of an invariant; else None
    family : points are compared with others of their family, which has a front of its own
    prepared : seconds by which the first run took longer than the next

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
    family: str = ""
    prepared: float = 0.0
    repeats: tuple[float, ...] = ()


Points: TypeAlias = Sequence[Measured]
M = TypeVar("M", bound=Measured)


def repeated(points: Sequence[M]) -> Iterator[list[M]]:
    """The points as each of their repeats alone would have them."""
    for n in range(max((len(p.repeats) for p in points), default=0) or 1):
        yield [replace(p, cost=p.repeats[n]) if n < len(p.repeats) else p for p in points]


@checked
def timed(*calls: Call, runs: int = 9, shortest: float = 2e-3, clock: Clock = perf_counter) -> Any:
    """The seconds that one call ``f()`` takes, a float; of several functions, which take turns, a
    tuple: those of the fastest of ``runs`` runs, each with enough calls to last ``shortest``
    seconds of the ``clock``. A first call, which may import or compile, does not count.

    >>> seconds = timed(lambda: sum(range(10)), lambda: sum(range(1000)))
    >>> len(seconds), min(seconds) > 0
    (2, True)
    """
    # the least: other work of the machine can only add to a time (measured on a busy machine: the
    # medians of two measurements differed by up to a factor of four, the minima by a tenth)
    times = tuple(map(min, timings(calls, runs, shortest, clock)))
    return times[0] if len(calls) == 1 else times


def timings(
    calls: Sequence[Call], runs: int = 5, shortest: float = 1e-3, clock: Clock = perf_counter
) -> list[tuple[float, ...]]:
    """For each function the seconds of a call in each of its runs, as :func:`timed` makes them."""
    timers = [(Timer(f, timer=clock), _enough_calls(f, shortest, clock)) for f in calls]
    rounds = [[timer.timeit(n) / n for timer, n in timers] for _ in range(runs)]
    return list(zip(*rounds, strict=True))


def of_repeats(repeats: Sequence[float]) -> dict[str, Any]:
    """The cost and the repeats of a point that was timed."""
    return {"cost": median(repeats), "repeats": tuple(repeats)}


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
    """|a - exact|/|exact| as a float, for two triples of components or Vectors of one frame; right
    to the last digit if the components of ``exact`` are of type mpf.

    >>> relative_error((3.0, 4.0, 0.5), (3.0, 4.0, 0.0))
    0.1
    """
    exact = tuple(exact)
    difference = sub3(tuple(a), exact)
    return float(sqrt(dot3(difference, difference)) / sqrt(dot3(exact, exact)))


@checked
def front(points: Points, cost: Cost = "cost") -> list[Measured]:
    """The points that no other beats in error or ``cost`` ("cost", the time, or "calls"), the
    cheapest first. Errors within a factor of two count as equal, and those of round-off.

    >>> coarse, fine = Measured("coarse", 1e-3, 1e-3), Measured("fine", 2e-3, 1e-9)
    >>> [p.method for p in front([fine, coarse, Measured("slow", 3e-3, 1e-9)])]
    ['coarse', 'fine']
    """
    best: list[Measured] = []
    for p in sorted(points, key=attrgetter(cost, "error")):
        if not best or NEAR < best[-1].error > EQUAL_WITHIN * p.error:
            best.append(p)
    return best


def fronts(points: Points, cost: Cost = "cost") -> dict[str, list[Measured]]:
    """By name the front of each family: of times, what the front of every repeat has."""
    runs = list(repeated(points)) if cost == "cost" else [list(points)]
    found = {}
    for name in dict.fromkeys(p.family for p in points):
        own = [n for n, p in enumerate(points) if p.family == name]
        fronts_of_runs = []
        for run in runs:
            place = {id(run[n]): n for n in own}
            fronts_of_runs.append({place[id(p)] for p in front([run[n] for n in own], cost)})
        if agreed := [points[n] for n in set.intersection(*fronts_of_runs)]:
            found[name] = sorted(agreed, key=attrgetter(cost, "error"))
    return found


def cheapest(points: Points, error: float) -> list[Measured]:
    """The cheapest point of each method within ``error``, the cheapest method first.

    >>> points = [Measured("a", 1e-3, 1e-9), Measured("a", 1e-4, 1e-3), Measured("b", 2e-3, 1e-9)]
    >>> [p.method for p in cheapest(points, 1e-6)]
    ['a', 'b']
    """
    within = sorted((p for p in points if p.error <= error), key=attrgetter("cost"))
    best: dict[str, Measured] = {}
    for p in within:
        best.setdefault(p.method, p)
    return list(best.values())


def of_equal_cost(points: Points, within: float = EQUAL_COST) -> list[Measured]:
    """The points, the cheapest first, whose costs differ from the least by less than a factor."""
    return [p for p in points if p.cost <= within * points[0].cost]
