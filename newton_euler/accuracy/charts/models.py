"""The chart of the models of one scene, and which one to take within a tolerance."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

from ...algebra.late import np
from ...algebra.names import listed
from ...motion.integration import integrate
from ...motion.prepared import prepared_model
from ...scenes.ladders import Ladder
from ..measurements.measure import EQUAL_WITHIN, Measured, Progress, of_equal_cost, silent
from .axes import GREY, INK, log_log, mark_better, marker_style, time_axis
from .words import times_as_much, two_digits

STEPS = (1, 2, 5, 10)  # a tolerance is one of these times a power of ten
RTOL = 1e-9  # tolerance of the integrations that are counted
NOISE = 1e-9  # share of the largest error below which an error is numerical


@dataclass(frozen=True)
class MeasuredModel(Measured):
    """A point that stands for a rung; its error is the largest within the time of the ladder, its
    cost the operations of one motion.

    usual : the median of the error over the time
    bound : of the error, by what the model neglects; infinite if none is known
    drops : the physics that it leaves out, in words
    """

    usual: float = 0.0
    bound: float = math.inf
    drops: tuple = ()


def measured_models(ladder: Ladder, progress: Progress = silent) -> list[MeasuredModel]:
    """A :class:`MeasuredModel` for each rung: the operations of a run, and the error."""
    points = []
    for n, rung in enumerate(ladder.rungs):
        progress(n / len(ladder.rungs), rung.name)
        distances, cost = ladder.distances(rung), _operations(ladder, rung)
        error, usual = float(distances.max()), float(np.median(distances))
        point = MeasuredModel(rung.name, cost, error, asked=RTOL, usual=usual)
        drops = tuple(neglected.what for neglected in rung.model.neglects)
        points.append(replace(point, bound=rung.bound(ladder.t), drops=drops))
    return points


def _operations(ladder, rung):
    """Operations of the rates times calls, by one method for all rungs: the same on any machine."""
    motion = integrate(rung.model, ladder.t, tuple(map(float, rung.start)), RTOL, "dop853")
    # rates that need none are made all the same
    return max(prepared_model(rung.model).traced.rhs.operations, 1) * motion.cost.calls


def usual_tolerance(points: Sequence[Measured]) -> float:
    """A tolerance in the middle of the errors, which some of the models meet and some do not."""
    largest = max((p.error for p in points if p.error < math.inf), default=0.0)
    errors = [p.error for p in points if NOISE * largest < p.error < math.inf]
    if not errors:
        return 1.0
    middle = math.sqrt(min(errors) * largest)
    power = 10.0 ** math.floor(math.log10(middle))
    return float(f"{min(STEPS, key=lambda s: abs(math.log(s * power / middle))) * power:.1g}")


def choice(points: Sequence[MeasuredModel], tolerance: float) -> MeasuredModel | None:
    """The first model within the tolerance, as :func:`~newton_euler.scenes.smallest`; or None."""
    left = points[-1].bound if points[-1].bound < math.inf else 0.0
    return next((p for p in points if min(p.bound, p.error + left) <= tolerance), None)


def beaten(points: Sequence[MeasuredModel]) -> list[tuple[MeasuredModel, MeasuredModel]]:
    """Models beaten by another, clearly cheaper and no less accurate: each with the first such."""

    def beats(q, p):
        return len(of_equal_cost([q, p])) == 1 and q.cost < p.cost and q.error <= p.error * 1.01

    by = ((p, next((q for q in points if beats(q, p)), None)) for p in points)
    return [(p, q) for p, q in by if q]


def draw_models(
    points: Sequence[MeasuredModel], ladder: Ladder, figure: Any, tolerance: float | None = None
) -> MeasuredModel | None:
    """The :func:`choice` within the tolerance, after drawing the errors of the rungs against their
    operations. A bar goes from the median over the time to the largest error; a grey dash is the
    bound that the model itself gives. The fullest rung stands at an arrow.
    """
    tolerance = tolerance or usual_tolerance(points)
    figure.set(layout_engine="constrained", size_inches=(11.0, 5.2))
    ax = figure.subplots()
    log_log(ax, "operations of a run to 1e-9", f"error of {ladder.of}: median to largest")
    shown = [p.error for p in points if 0 < p.error < math.inf] or [1.0]
    low, high = min(shown) / 100, 30 * max(*shown, tolerance)
    ax.set_ylim(low / 12, high)
    for n, p in enumerate(points):
        _draw_rung(ax, n, p, low, high / 5)
    ax.axhline(tolerance, color="#D55E00", lw=1.2, ls="--")
    place = {"xytext": (-4, 3), "textcoords": "offset points", "ha": "right"}
    text = f"tolerance {two_digits(tolerance)} {_unit(ladder)}"
    ax.annotate(text, (1, tolerance), xycoords=ax.get_yaxis_transform(), color="#D55E00", **place)
    chosen = choice(points, tolerance)
    if chosen:
        ring = {"ms": 19, "mfc": "none", "mec": INK, "mew": 1.6, "ls": "none"}
        height = max(chosen.error, low)
        ax.plot([chosen.cost], [height], "o", label="smallest within the tolerance", **ring)
    ax.set_title(f"models of {ladder.name}, until t = {ladder.t:g} s", fontsize=11)
    ax.margins(x=0.15)
    mark_better(ax)
    time_axis(ax, [p.cost for p in points], "")
    look = {"frameon": False, "fontsize": 9, "labelspacing": 0.9}
    ax.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), **look)
    return chosen


def _draw_rung(ax, n, p, low, high):
    """A rung with its number, its bar of errors, and its bound; in the legend what it drops."""
    drops = "drops " + ",\n    ".join(p.drops) if p.drops else "the fullest, drops nothing"
    label = f"{n + 1}  {p.method}\n    {drops}"
    height = min(max(p.error, low), high)
    style = marker_style(n)
    if 0 < p.error < math.inf:
        ax.plot([p.cost] * 2, [max(p.usual, low), height], color=style["color"], lw=2, zorder=2)
    if p.error and p.bound < math.inf:
        bar = {"color": GREY, "lw": 0.8, "ls": ":", "marker": "_", "ms": 12, "zorder": 1}
        ax.plot([p.cost] * 2, [height, p.bound], markevery=[1], **bar)
    ax.plot([p.cost], [height], ms=8, ls="none", label=label, zorder=3, **style)
    text = {"textcoords": "offset points", "fontsize": 10}
    ax.annotate(f"{n + 1}", (p.cost, height), (9, 5), **text)
    if not low <= p.error <= high:
        end, side = (-34, "0") if p.error < low else (24, "∞" if p.error == math.inf else "")
        arrow = {"arrowstyle": "<-", "color": INK}
        ax.annotate(side, (p.cost, height), (0, end), ha="center", arrowprops=arrow, **text)


def _unit(ladder):
    return ladder.of.rpartition(", ")[2] if ", " in ladder.of else ""


def models_caption(
    points: Sequence[MeasuredModel], ladder: Ladder, tolerance: float | None = None
) -> str:
    """What the chart of :func:`draw_models` shows, in sentences that follow from the points."""
    tolerance = tolerance or usual_tolerance(points)
    text = [_chosen(points, ladder, tolerance), _fullest(points), *_useless(points)]
    return " ".join(filter(None, [*text, *_of_equal_error(points)]))


def _chosen(points, ladder, tolerance):
    within, p = f"{two_digits(tolerance)} {_unit(ladder)}".strip(), choice(points, tolerance)
    if p is None:
        return f"No model stays within {within}."
    text = f"Within {within} the smallest model is {_name(points, p)}, "
    text += f"{two_digits(p.cost)} operations a run"
    if p.error:
        text += f", off by {two_digits(p.error)} {_unit(ladder)} at most".replace("  ", " ")
    rest = (q for q in points if q.error <= tolerance and q is not p)
    equal = [q for q in rest if q.cost <= 1.2 * p.cost]
    if equal:
        verb = "costs" if len(equal) == 1 else "cost"
        text += f"; {listed(_name(points, q) for q in equal)} {verb} about the same"
    left = f" It leaves out {listed(p.drops)}." if p.drops else " It leaves out nothing."
    return f"{text}.{left}"


def _name(points, p):
    return f"{points.index(p) + 1} ({p.method})"


def _fullest(points):
    least = of_equal_cost(sorted(points, key=lambda p: p.cost))
    cheapest, full = min(least, key=points.index), points[-1]
    if full in least:
        return "The fullest model costs no more than the cheapest."
    ratio = times_as_much(full.cost / cheapest.cost)
    return f"The fullest takes {ratio} as many operations as the cheapest, {cheapest.method}."


def _useless(points):
    for p, by in beaten(points):
        accurate = "no more accurate" if by.error > p.error / EQUAL_WITHIN else "less accurate"
        yield f"{_name(points, p)} costs more than {points.index(by) + 1} and is {accurate}."


def _of_equal_error(points):
    """Neighbours on the ladder of which the fuller one buys no accuracy, as far as it is known."""
    for p, q in pairwise(points):
        if q.error and p.error and 1 / EQUAL_WITHIN < p.error / q.error < EQUAL_WITHIN:
            yield f"The errors of {points.index(p) + 1} and {points.index(q) + 1} are about equal."
