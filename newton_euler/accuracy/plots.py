"""Charts of what was measured: the methods on one scene
(:mod:`newton_euler.accuracy.work_precision`), and the models of one (:func:`measured_models`).
"""

import math
from dataclasses import replace
from functools import partial

from ..motion.integration import prepare
from .measure import FLOOR, Measured, chart, log_log, marker_style, timed
from .work_precision import NAMES

AUTO = {"label": "auto", "color": "black", "marker": "*", "mfc": "none", "ms": 12, "lw": 1.6}


def draw_methods(found, figure):
    """The front of the methods by time, after drawing three charts: error against time, error
    against calls, drift of invariants against tolerance.

    found : a :class:`~newton_euler.accuracy.work_precision.WorkPrecision`
    "auto", which only chooses one of the methods, is drawn over them.
    """
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
    """The method in the legend, with the time to prepare its first run if that is above noise."""
    seconds = found.preparing.get(name, 0.0)
    cost = next((p.cost for p in found.points if p.method == name), 0.0)
    return f"{name}\n  {1e3 * seconds:.0f} ms to prepare" if seconds > max(2e-3, cost) else name


def _draw_drift(methods, auto, ax):
    known = [p for p in methods if p.drift is not None]
    ax.set_title("drift of the invariants" if known else "no invariant is known", fontsize=10)
    if not known:
        ax.set_axis_off()
        return
    log_log(ax, "error asked for, rtol", "worst drift of an invariant, relative")
    styles = {name: {"ms": 7, "lw": 0.8, **marker_style(n)} for n, name in enumerate(NAMES)}
    for method, style in {**styles, "auto": AUTO}.items():
        own = [p for p in [*known, *auto] if p.method == method]
        ax.plot([p.asked for p in own], [max(p.drift, FLOOR) for p in own], **style)
    asked = sorted({p.asked for p in known})
    (diagonal,) = ax.plot(asked, asked, color="#999999", lw=1, ls=":")
    ax.legend([diagonal], ["drift = rtol"], loc="upper left", frameon=False, fontsize=9)


def measured_models(ladder, progress=lambda fraction, words: None):
    """A :class:`~newton_euler.accuracy.Measured` for each rung of a
    :class:`~newton_euler.scenes.ladders.Ladder`: the time of its motion, and its error.

    The time is that of a prepared run (:func:`newton_euler.prepare`) to 1e-9; the error is in the
    ladder's unit, that of the fullest rung 0.
    """
    points = []
    for n, rung in enumerate(ladder.rungs):
        progress(n / len(ladder.rungs), rung.name)
        error = ladder.error(rung)
        run = partial(prepare(rung.model, 1e-9), ladder.t, tuple(map(float, rung.start)))
        points.append(Measured(rung.name, timed(run, runs=5), error, asked=1e-9))
    return points


def draw_models(points, ladder, figure):
    """The front of the rungs, after drawing their errors, in the ladder's unit, against the times
    of their motions.

    A bar above a point ends at the bound of the error that the model itself gives. The fullest
    rung, which the others are measured against, stands below at the arrow.
    """
    figure.set(layout_engine="constrained", size_inches=(9.0, 5.6))
    ax = figure.subplots()
    floor = min((p.error for p in points if p.error), default=1.0) / 100
    best = chart(points, ax, floor=floor, legend=False)
    costs = [p.cost for p in points]
    middle = math.sqrt(min(costs) * max(costs))
    for n, p in enumerate(points):
        height, bound = max(p.error, floor), ladder.rung(p.method).bound(ladder.t)
        if p.error and bound < math.inf:
            bar = {"color": "#999999", "lw": 1, "marker": "_", "ms": 10, "zorder": 1}
            ax.plot([p.cost] * 2, [height, bound], **bar)
        near = any(
            q.error and abs(math.log(q.cost / p.cost)) < 0.3 and q.error < 3 * p.error < 9 * q.error
            for q in points[:n]
        )
        # to the left of a point in the right half; below where another label is in the usual place
        place, side = (12, -16 if near else 6), "left"
        if p.cost > middle:
            place, side = (-12, -14), "right"
        text = {"text": p.method.removeprefix(f"{ladder.name}, "), "fontsize": 9, "ha": side}
        ax.annotate(xy=(p.cost, height), xytext=place, textcoords="offset points", **text)
    title = f"models of {ladder.name}, until t = {ladder.t:g}: their times and their errors"
    ax.set_title(title, fontsize=11)
    ax.set(xlabel="time of a run to 1e-9", ylabel=f"error of {ladder.of}")
    ax.margins(x=0.2)
    ax.set_ylim(floor / 12, 30 * (max(p.error for p in points) or 1.0))  # bounds may be far beyond
    return best
