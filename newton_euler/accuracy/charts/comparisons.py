"""The charts of :mod:`..measurements.comparisons`, their captions, and tables of points."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby
from operator import attrgetter
from typing import Any

from ...algebra.late import EngFormatter
from ...algebra.names import listed
from ..measurements import measure
from ..measurements.comparisons import Comparison, ComparisonPoint
from ..measurements.measure import ALIKE, EQUAL_WITHIN, NEAR, ROUND_OFF, Measured, of_equal_cost
from .axes import COLOURS, MARKERS, chart, log_log
from .words import about_times, agreed, seconds, two_digits

WRONG = 1e-2  # a relative error


def draw_comparison(
    comparison: Comparison, points: Sequence[ComparisonPoint], figure: Any
) -> list[Measured]:
    """The fronts of all questions, after drawing two charts in a row for each."""
    rows, best = len(comparison.questions), []
    figure.set(layout_engine="constrained", size_inches=(11.5, 0.6 + 3.6 * rows))
    figure.suptitle(comparison.title)
    axes = figure.subplots(rows, 2, squeeze=False)
    for question, (left, right) in zip(comparison.questions, axes, strict=True):
        best += _draw(question, [p for p in points if p.question is question], left, right)
    return best


def _draw(question, points, left, right):
    """The front of the points, drawn against the setting (``left``) and the cost (``right``)."""
    points = [replace(p, error=max(p.error, ROUND_OFF)) for p in points]
    by_method = [[p for p in points if p.method == name] for name in question.methods]
    log_log(left, question.across[1], "relative error")
    for n, own in enumerate(by_method):
        style = {"marker": MARKERS[n], "color": COLOURS[n], "lw": 1}
        # marks drawn first are larger, to be seen behind others
        left.plot([p.x for p in own], [p.error for p in own], ms=9 - 1.3 * n, **style)
    worst = [_worst(own) for own in by_method]
    best = chart(worst if question.worst_only else points, right)
    costs = [p.cost for p in points]
    right.set(ylabel="", xlim=(min(costs) / 2, 2 * max(costs)))
    against = "the worst of each, against its cost" if question.worst_only else "against the cost"
    for ax, title in ((left, question.what), (right, against)):
        ax.set_title(title, fontsize=10, loc="left")
    return best


def points_table(
    points: Sequence[Measured], error: str = "relative", cost: str = "time", unit: str = "s"
) -> str:
    """The points as a table."""
    engineering, width = EngFormatter(unit=unit, places=1), max(len(p.setting) for p in points)
    rows = [
        f"  {p.method:44} {p.setting:{width}} {engineering(p.cost):>9}  {p.error:8.2g}"
        for p in points
    ]
    return "\n".join([f"  {'':{45 + width}} {cost:>9}  error, {error}", *rows])


def ways_caption(points: Sequence[Measured]) -> str:
    """The cheapest and most accurate of several ways to one result, where all repeats agree."""
    return agreed(map(_of_ways, measure.repeated(points)))


def _of_ways(points):
    best = measure.cheapest(points, max(NEAR, EQUAL_WITHIN * min(p.error for p in points)))
    yield from _of_best(best, points)
    yield from (_cheaper(points, best), _prepared(points), _beaten(points, best))


def _of_best(best, points):
    equal = of_equal_cost(best, ALIKE)
    error = f"(error {two_digits(max(*(p.error for p in best), ROUND_OFF))} or less)"
    yield f"Most accurate {error}: {listed(p.method for p in points if p in best)}."
    if len(best) == 1:
        return
    if len(equal) > 1:
        names = listed(p.method for p in points if p in equal)
        yield f"Of these {names} cost about the same, least."
        return
    yield f"Of these {best[0].method} is the cheapest."
    ratio = about_times(best[1].cost / best[0].cost)
    yield f"{best[1].method} takes {ratio} as long as {best[0].method}."


def _cheaper(points, best):
    """What costs less than the most accurate, and what that loses."""
    least = min(points, key=lambda p: p.cost)
    if least in best:
        return ""
    alike = len(of_equal_cost([least, best[0]], ALIKE)) > 1
    how = "costs about the same" if alike else f"is {about_times(best[0].cost / least.cost)} faster"
    return f"{least.method} {how}, with an error of {two_digits(least.error)}."


def _prepared(points):
    most = max(points, key=lambda p: p.prepared)
    if most.prepared < 2e-3:
        return ""
    return f"The first call of {most.method} takes {seconds(most.prepared)} more, to prepare."


def _beaten(points, best):
    """Those that cost more than the best and are less accurate."""
    accurate, limit = {p.method for p in best}, ALIKE * best[0].cost
    lost = dict.fromkeys(p.method for p in points if p.cost > limit and p.method not in accurate)
    return f"Dearer and less accurate than {best[0].method}: {listed(lost)}." if lost else ""


def comparison_caption(comparison: Comparison, points: Sequence[ComparisonPoint]) -> str:
    """For each question the ways right at every setting, their cheapest, and where others fail."""
    return agreed(
        [s for q in comparison.questions for s in _answer(q, [p for p in again if p.question is q])]
        for again in measure.repeated(points)
    )


def _worst(own):
    """The point of the largest error, the same for chart and caption: round-off is no worse."""
    return max(own, key=lambda p: max(p.error, ROUND_OFF))


def _answer(question, points):
    methods = [[p for p in points if p.method == name] for name in question.methods]
    worst = [_worst(own) for own in methods]
    right = [p for p in worst if p.error <= max(NEAR, EQUAL_WITHIN * min(q.error for q in worst))]
    first, *more = _right(right)
    yield f"{question.what[0].upper()}{question.what[1:]}: {first}"
    yield from more
    names = {p.method for p in right}
    yield from (f"{_others(question, own)}." for own in methods if own[0].method not in names)


def _right(right):
    error = two_digits(max(*(p.error for p in right), ROUND_OFF))
    yield f"{_quoted(right)} {'are' if len(right) > 1 else 'is'} within {error} at every setting."
    least = of_equal_cost(sorted(right, key=lambda p: p.cost), ALIKE)
    if len(least) > 1:
        yield f"{_quoted(p for p in right if p in least)} cost about the same."
    elif len(right) > 1:
        yield f"{_quoted(least)} is the cheapest of them."


def _others(question, own):
    """The best and the worst of a method that is not right everywhere."""
    best, worst = min(own, key=attrgetter("error")), _worst(own)
    letter = question.across[0]
    text = f"{_quoted(own[:1])}: at best {two_digits(max(best.error, ROUND_OFF))}, at {letter} = "
    text += two_digits(best.x)
    if best.error <= WRONG < worst.error:
        return f"{text}; wrong by over 1 % at {letter} = {listed(_runs(own))}"
    return f"{text}; at worst {two_digits(worst.error)}, at {letter} = {two_digits(worst.x)}"


def _quoted(points):
    return listed(f"“{p.method}”" for p in points)


def _runs(own):
    """The settings, in words, from which to which a method is wrong without a break."""
    for wrong, run in groupby(own, lambda p: p.error > WRONG):
        ends = [two_digits(p.x) for p in run]
        if wrong:
            yield ends[0] if len(ends) == 1 else f"{ends[0]} to {ends[-1]}"
