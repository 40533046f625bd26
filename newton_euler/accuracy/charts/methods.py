"""The chart of the methods of integration on one scene (:mod:`..measurements.work_precision`)."""

from dataclasses import replace

from ..measurements.measure import EQUAL_COST, ROUND_OFF, cheapest, fronts, of_equal_cost
from ..measurements.work_precision import NAMES, STEPPING
from .axes import FLOOR, GREY, chart, log_log, marker_style
from .words import listed, number, seconds, times

AUTO = {"label": "auto", "color": "black", "marker": "*", "mfc": "none", "ms": 12, "lw": 1.6}
SHORT = 2e-3  # seconds; a shorter preparation is not mentioned
OF_INTEREST = (1e-6, 1e-10)  # relative errors for which the caption names the cheapest method


def draw_methods(found, figure):
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
    entries = [_entry(name, found) for name in names]
    figure.legend(handles, entries, loc="outside right center", frameon=False, fontsize=9)
    return best


def _entry(name, found):
    """The method in the legend, with the time to prepare its first run if that is worth a word."""
    time = found.preparing.get(name, 0.0)
    return f"{name}\n  {1e3 * time:.0f} ms to prepare" if time > SHORT else name


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


def methods_caption(found):
    """What the chart of :func:`draw_methods` shows, in sentences that follow from the points."""
    points = [p for p in found.points if p.method != "auto"]
    stepping = [p for p in points if p.family == STEPPING]
    closed = [p for p in points if p.family != STEPPING]
    text = [_cheapest_within(stepping, error) for error in OF_INTEREST]
    text += [_front(stepping), _closed_form(closed, stepping), _preparing(found, stepping)]
    return " ".join(filter(None, [*text, _small_drift(points), _left_out(found)]))


def _cheapest_within(points, error):
    found = cheapest(points, error)
    if not found:
        return f"No stepping method that was measured is right to {number(error)}."
    equal = of_equal_cost(found)
    text = f"Within an error of {number(error)}, {listed(p.method for p in equal)}"
    if len(equal) > 1:
        text += f" cost the same among the stepping methods, about {seconds(equal[0].cost)}"
    else:
        text += f" is the cheapest stepping method, at {seconds(equal[0].cost)}"
    others = found[len(equal) :]
    if others:
        text += f"; next comes {others[0].method}, {times(others[0].cost / equal[0].cost)} as long"
    return f"{text}."


def _front(points):
    names = dict.fromkeys(p.method for best in fronts(points).values() for p in best)
    return f"Front of the stepping methods: {listed(names)}." if len(names) > 1 else ""


def _closed_form(closed, stepping):
    if not closed or not stepping:
        return "" if closed else "There is no closed form."
    best, rival = (min(own, key=lambda p: p.cost) for own in (closed, stepping))
    error = number(max(best.error, ROUND_OFF))
    text = f"The closed form takes {seconds(best.cost)} and is right to {error}: "
    if len(of_equal_cost(sorted([best, rival], key=lambda p: p.cost))) > 1:
        return f"{text}as cheap as the cheapest stepping method."
    if best.cost < rival.cost:
        return f"{text}cheaper than every stepping method at any error."
    return f"{text}{times(best.cost / rival.cost)} as long as {rival.method} at its coarsest."


def _preparing(found, stepping):
    """The method that takes longest to prepare, and after how many runs that has paid."""
    above = {m: s for m, s in found.preparing.items() if m != "auto" and s > SHORT}
    if not above:
        return ""
    method = max(above, key=above.get)
    text = f"{method} takes {seconds(above[method])} to prepare its first run"
    within = cheapest(stepping, OF_INTEREST[0])
    own = next((p for p in within if p.method == method), None)
    rival = next((p for p in within if above.get(p.method, 0.0) < above[method] / 2), None)
    if own and rival and rival.cost > EQUAL_COST * own.cost:
        runs = (above[method] - above.get(rival.method, 0.0)) / (rival.cost - own.cost)
        count = "one run" if runs < 1.5 else f"{runs:.0f} runs"
        text += f", earned back against {rival.method} by {count} to {number(OF_INTEREST[0])}"
    return f"{text}."


def _small_drift(points):
    """The method whose drift is the smallest part of its error: a warning."""
    known = [p for p in points if p.drift and p.error > 1e-13]
    if not known:
        return ""
    worst = max(known, key=lambda p: p.error / p.drift)
    if worst.error < 10 * worst.drift:
        return ""
    text = f"A small drift proves nothing: of {worst.method} at rtol = {number(worst.asked)}"
    return f"{text} the error is {times(worst.error / worst.drift)} the drift."


def _left_out(found):
    slow, unable = found.too_slow, found.unable
    text = f"Too slow to be asked for all digits: {listed(slow)}. " if slow else ""
    text += f"Cannot reach all tolerances: {listed(unable)}." if unable else ""
    return text.strip()
