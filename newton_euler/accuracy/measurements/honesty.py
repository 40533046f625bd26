"""Whether the methods of integration keep their word: the true error against the tolerance, where a
larger one is a broken promise (W. H. Enright and J. D. Pryce 1987: the method is deceived), and the
estimate over the true error, the effectivity index: not below one, nor far above.

>>> answers = honesty(("sphere on an incline",), (1e-3, 1e-9), ("exact", "dop853", "verlet"))
>>> [t.met for t in tallies(answers) if t.method == "exact"], sum(a.silent for a in answers)
([1.0], 0)
>>> [a.asked for a in answers if a.absent == "refused"]  # by verlet
[1e-09]
"""

import csv
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from os import PathLike
from statistics import fmean, median
from typing import NamedTuple

from ...algebra.late import EngFormatter
from ...motion.model import ModelError
from ...scenes import scene as scene_named
from .measure import Measured, Progress, silent
from .work_precision import NAMES, TOLERANCES, Reference, can_use, timed_run

EPS = 2.0**-53  # relative errors below half a unit of the last place are not known
GROSS = 10.0  # an error above this many times tolerance and estimate is silently wrong
# seconds that a run may take; with less, runs that break their promise were left out while the
# machine was busy, and the counts depended on it
PATIENCE = 1.0
REFUSED, FAILED = "refused", "failed"


@dataclass(frozen=True)
class MethodResult(Measured):
    """A method's result on one ``problem`` for one error ``asked``; ``cost`` of run and estimate.

    estimate : of the error, by the method itself; None if it has none
    absent : "" for an answer; "refused" in ``words`` of the engine, "failed" without them or
        without an end; the error is then nan

    >>> a = MethodResult("mine", cost=1e-3, error=2e-5, asked=1e-6, estimate=1e-7)
    >>> a.kept, a.covered, a.silent
    (False, False, True)
    """

    asked: float = math.nan
    estimate: float | None = None
    problem: str = ""
    absent: str = ""
    words: str = ""

    @property
    def kept(self) -> bool:
        """True if the true error is within the tolerance."""
        return self.error <= self.asked

    @property
    def times_asked(self) -> float:
        """The true error over the tolerance: above one, the promise is broken."""
        return self.error / self.asked

    @property
    def covered(self) -> bool | None:
        """True if the estimate is not below the true error; None if there is no estimate."""
        return None if self.estimate is None or self.absent else self.estimate >= self.error

    @property
    def effectivity(self) -> float | None:
        """The estimate over the true error, each at least half a unit of the last digit."""
        if self.estimate is None or self.absent:
            return None
        return max(self.estimate, EPS) / max(self.error, EPS)

    @property
    def silent(self) -> bool:
        """True if the error is more than ten times both the tolerance and the estimate."""
        return self.error > GROSS * max(self.asked, self.estimate or 0.0)


def honesty(
    names: Sequence[str],
    tolerances: Sequence[float] = TOLERANCES[:-1],
    methods: Sequence[str] = NAMES,
    longest: float = PATIENCE,
    progress: Progress = silent,
) -> list[MethodResult]:
    """The results of every method at every tolerance, on each of these scenes that it can use;
    errors as in :func:`.work_precision.work_precision`.

    longest : a method whose run takes more seconds is not asked for more digits of this scene
    """
    answers: list[MethodResult] = []
    for n, name in enumerate(names):
        reference = Reference(scene_named(name))
        for m, method in enumerate(methods):
            progress((n + m / len(methods)) / len(names), f"{name}: {method}")
            for rtol in tolerances if can_use(method, reference.model) else ():
                answers.append(_answer(name, reference, method, rtol))
                if answers[-1].cost > longest:
                    break
    return answers


def _answer(name, reference, method, rtol):
    about = {"asked": rtol, "problem": name}

    def run():
        motion = reference.run(method, rtol)
        return motion, float(motion.error)  # which may take a second run

    try:
        (motion, estimate), repeats, _ = timed_run(run, method)
        cost = median(repeats)
    except ModelError as error:
        return MethodResult(method, math.nan, math.nan, absent=REFUSED, words=str(error), **about)
    estimate = None if math.isnan(estimate) else estimate
    return MethodResult(method, cost, reference.error(motion), estimate=estimate, **about)


def relative_costs(answers: Sequence[MethodResult]) -> list[MethodResult]:
    """The answers with costs over that of the cheapest, one that kept its word if any did."""
    least: dict = {}
    for a in answers:
        if not a.absent and a.cost > 0:  # a coarse clock may show nothing
            key = a.problem, a.asked
            least[key] = min(least.get(key, (True, math.inf)), (not a.kept, a.cost))
    absent = True, math.nan
    return [replace(a, cost=a.cost / least.get((a.problem, a.asked), absent)[1]) for a in answers]


def comparable(answers: Sequence[MethodResult]) -> tuple[Sequence[MethodResult], bool]:
    """The answers, with :func:`relative_costs` if of several problems; and whether they are."""
    several = len({a.problem for a in answers}) > 1
    return (relative_costs(answers) if several else answers), several


class Tally(NamedTuple):
    """How honest one method was. A part or a median of nothing is nan.

    runs, refused, failed : how often it was asked, and how often without an answer
    met, covers : the part of its answers in the tolerance, and of its estimates not below the error
    ratio, cost : the median of estimate over true error; of the cost, in seconds or relative
    silent : how many answers were wrong by more than ten times both tolerance and estimate
    """

    method: str
    runs: int
    met: float
    covers: float
    ratio: float
    silent: int
    refused: int
    failed: int
    cost: float


def tallies(answers: Iterable[MethodResult]) -> list[Tally]:
    """A :class:`Tally` for each method, the cheapest first, those without an answer last."""
    answers = list(answers)
    methods = dict.fromkeys(a.method for a in answers)
    found = [_tally(method, [a for a in answers if a.method == method]) for method in methods]
    return sorted(found, key=lambda t: (math.isnan(t.cost), t.cost))


def _tally(method, asked):
    own = [a for a in asked if not a.absent]
    estimated = [a for a in own if a.covered is not None]
    return Tally(
        method,
        runs=len(asked),
        met=_unless_empty(fmean, [a.kept for a in own]),
        covers=_unless_empty(fmean, [a.covered for a in estimated]),
        ratio=_unless_empty(median, [a.effectivity for a in estimated]),
        silent=sum(a.silent for a in own),
        refused=sum(a.absent == REFUSED for a in asked),
        failed=sum(a.absent == FAILED for a in asked),
        cost=_unless_empty(median, [a.cost for a in own]),
    )


def _unless_empty(f, numbers):
    return f(numbers) if numbers else math.nan


def percent(part: float) -> str:
    """A part as text, rounded so that 100 % means all of them; "" for nan.

    >>> percent(1.0), percent(0.99996), percent(math.nan)
    ('100', '99.9', '')
    """
    return "" if math.isnan(part) else "100" if part == 1.0 else f"{math.floor(1e3 * part) / 10}"


def ratio_text(ratio: float) -> str:
    """A ratio as text, in two digits and without powers of ten; "" for nan.

    >>> ratio_text(1.234), ratio_text(12.34), ratio_text(1234.0), ratio_text(0.001234)
    ('1.2', '12', '1234', '0.0012')
    """
    return "" if math.isnan(ratio) else f"{ratio:.0f}" if ratio >= 9.95 else f"{ratio:.2g}"


def cost_text(cost: float, relative: bool) -> str:
    """A cost as text, "28.1 µs", or "7.3 x" relative to the cheapest; "" for nan."""
    seconds = EngFormatter(unit="s", places=1)
    return "" if math.isnan(cost) else f"{ratio_text(cost)} x" if relative else seconds(cost)


# what is written of a tally, by its heading
CELLS: dict[str, Callable[[Tally, bool], object]] = {
    "runs": lambda t, relative: t.runs,
    "met %": lambda t, relative: percent(t.met),
    "covers %": lambda t, relative: percent(t.covers),
    "est/true": lambda t, relative: ratio_text(t.ratio),
    "silent": lambda t, relative: t.silent,
    "refused": lambda t, relative: t.refused,
    "failed": lambda t, relative: t.failed,
    "cost": lambda t, relative: cost_text(t.cost, relative),
}


def table(answers: Sequence[MethodResult]) -> str:
    """The tallies as text, their costs as :func:`comparable`."""
    answers, relative = comparable(answers)
    found = tallies(answers)
    width = max([len("method"), *(len(t.method) for t in found)])
    lines = [f"  {'method':{width}}" + "".join(f"{head:>10}" for head in CELLS)]
    for t in found:
        cells = (cell(t, relative) or "" for cell in CELLS.values())
        lines.append(f"  {t.method:{width}}" + "".join(f"{cell:>10}" for cell in cells))
    return "\n".join(lines)


COLUMNS = ("method", "problem", "asked", "cost", "error", "estimate", "absent", "words")


def write_csv(answers: Iterable[MethodResult], path: str | PathLike) -> None:
    """Write the answers, one a line, under :data:`COLUMNS`."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        writer.writerows([getattr(a, c) for c in COLUMNS] for a in answers)
