"""The chart of the methods of integration on one scene (:mod:`..measurements.work_precision`)."""

from dataclasses import replace
from typing import Any

from ...algebra.names import listed
from ..measurements.measure import ALIKE, ROUND_OFF, Measured, cheapest, of_equal_cost, repeated
from ..measurements.work_precision import NAMES, STEPPING, WorkPrecision
from .axes import FLOOR, GREY, chart, log_log, marker_style
from .words import about, about_times, agreed, seconds, times_as_much, two_digits

AUTO = {"label": "auto", "color": "black", "marker": "*", "mfc": "none", "ms": 12, "lw": 1.6}
SHORT = 2e-3  # seconds; a shorter preparation is not mentioned
OF_INTEREST = (1e-6, 1e-10)  # relative errors for which the caption names the cheapest method


def draw_methods(found: WorkPrecision, figure: Any) -> list[Measured]:
    """The fronts by time, after drawing a :class:`.WorkPrecision`; "auto", a choice, is in none."""
    scene = found.scene
    figure.set(layout_engine="constrained", size_inches=(13.0, 4.9))
    figure.suptitle(f"{scene.name}, section {scene.section}: {scene.description}", fontsize=12)
    left, middle, right = figure.subplots(1, 3)
    points = [replace(p, error=max(p.error, FLOOR)) for p in found.points]
    methods = [p for p in points if p.method != "auto"]
    auto = [p for p in points if p.method == "auto"]
    best = chart(methods, left, order=NAMES, legend=False)
    # no place for 0 on a logarithmic axis
    chart([p for p in methods if p.calls], middle, cost="calls", order=NAMES, legend=False)
    for ax, costs in (left, [p.cost for p in auto]), (middle, [p.calls for p in auto]):
        ax.plot(costs, [p.error for p in auto], zorder=4, **AUTO)
    left.set(xlabel="time of a run", ylabel="true error at the end, relative")
    middle.set(xlabel="calls of the right-hand side", ylabel="")
    _draw_drift(methods, auto, right)
    handles, names = left.get_legend_handles_labels()
    entries = []
    for name in names:  # with the time to prepare the first run, if that is worth a word
        time = found.preparing.get(name, 0.0)
        entries.append(f"{name}\n  {1e3 * time:.0f} ms to prepare" if time > SHORT else name)
    figure.legend(handles, entries, loc="outside right center", frameon=False, fontsize=9)
    return best


def _draw_drift(methods, auto, ax):
    known = [p for p in methods if p.drift is not None]
    ax.set_title("drift of the invariants" if known else "no invariant is known", fontsize=10)
    if not known:
        ax.set_axis_off()
        return
    log_log(ax, "tolerance rtol", "worst drift of an invariant, relative")
    styles = {name: {"ms": 7, "lw": 0.8, **marker_style(n)} for n, name in enumerate(NAMES)}
    for method, style in {**styles, "auto": AUTO}.items():
        own = [p for p in [*known, *auto] if p.method == method]
        ax.plot([p.asked for p in own], [max(p.drift, FLOOR) for p in own], **style)
    asked = sorted({p.asked for p in known})
    (diagonal,) = ax.plot(asked, asked, color=GREY, lw=1, ls=":")
    ax.legend([diagonal], ["drift = rtol"], loc="upper left", frameon=False, fontsize=9)


def methods_caption(found: WorkPrecision) -> str:
    """What the chart of :func:`draw_methods` shows: the sentences that each repeat would write."""
    again = (replace(found, points=tuple(points)) for points in repeated(found.points))
    return agreed(map(_sentences, again))


def _sentences(found):
    points = [p for p in found.points if p.method != "auto"]
    stepping = [p for p in points if p.family == STEPPING]
    closed = [p for p in points if p.family != STEPPING]
    for error in OF_INTEREST:
        yield from _cheapest_within(stepping, error)
    yield from _closed_form(closed, stepping)
    yield from _preparing(found, stepping)
    yield _small_drift(points)
    left_out = {"Too slow here to be asked for all digits": found.too_slow}
    left_out["Cannot reach all tolerances"] = found.unable
    yield from (f"{why}: {listed(names)}." for why, names in left_out.items() if names)


def _cheapest_within(points, error):
    found = cheapest(points, error)
    if not found:
        yield f"No stepping method that was measured is right to {two_digits(error)}."
        return
    equal = of_equal_cost(found, ALIKE)
    names = [p.method for p in sorted(equal, key=points.index)]
    what = "is the cheapest stepping method" if len(equal) == 1 else "cost about the same, least"
    yield f"Within an error of {two_digits(error)}, {listed(names)} {what}."
    for other in found[len(equal) :][:1]:
        ratio = about_times(other.cost / found[0].cost)
        yield f"There {other.method} takes {ratio} as long as {found[0].method}."


def _closed_form(closed, stepping):
    if not closed or not stepping:
        yield "" if closed else "There is no closed form."
        return
    best, rival = (min(own, key=lambda p: p.cost) for own in (closed, stepping))
    error = two_digits(max(ROUND_OFF, *(p.error for p in closed)))
    yield f"The closed form is right to {error}."
    if len(of_equal_cost(sorted([best, rival], key=lambda p: p.cost), ALIKE)) > 1:
        yield "It costs about as much as the cheapest stepping method."
    elif best.cost < rival.cost:
        yield "It is cheaper than every stepping method at any error."
    else:
        ratio = about_times(best.cost / rival.cost)
        yield f"It takes {ratio} as long as {rival.method} at its coarsest."


def _preparing(found, stepping):
    """The method that takes longest to prepare, and after how many runs that has paid."""
    above = {m: s for m, s in found.preparing.items() if m != "auto" and s > SHORT}
    if not above:
        return
    method = max(above, key=above.get)
    yield f"{method} takes {seconds(above[method])} to prepare its first run."
    within = cheapest(stepping, OF_INTEREST[0])
    own = next((p for p in within if p.method == method), None)
    rival = next((p for p in within if above.get(p.method, 0.0) < above[method] / 2), None)
    if own and rival and rival.cost > ALIKE * own.cost:
        runs = (above[method] - above.get(rival.method, 0.0)) / (rival.cost - own.cost)
        count = "the first run" if runs < 1 else f"about {two_digits(about(runs))} runs"
        least = two_digits(OF_INTEREST[0])
        yield f"Against {rival.method} that is earned back by {count} to {least}."


def _small_drift(points):
    """The method whose drift is the smallest part of its error: a warning."""
    known = [p for p in points if p.drift and p.error > 1e-13]
    if not known:
        return ""
    worst = max(known, key=lambda p: p.error / p.drift)
    if worst.error < 10 * worst.drift:
        return ""
    text = f"A small drift proves nothing: of {worst.method} at rtol = {two_digits(worst.asked)}"
    return f"{text} the error is {times_as_much(worst.error / worst.drift)} the drift."
