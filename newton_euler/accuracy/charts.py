"""Figures of speed against accuracy: the methods on one scene, and the models of one.

Both are drawn from what was just measured, by :mod:`.precision` or by :func:`measured_models`.
"""

import math
from dataclasses import replace

from ..motion import prepare
from . import Measured, chart, look, timed
from .precision import NAMES

FLOOR = 1e-17  # smaller errors are drawn there: a float cannot have them
SIZE = (13.0, 4.9)  # inches
AUTO = {"color": "black", "marker": "*", "mfc": "none", "ms": 12, "lw": 1.6, "zorder": 4, "label": "auto"}


# -- methods


def draw_methods(found, figure):
    """Three charts side by side: error against time, error against calls of the right-hand side, drift of the invariants against what was asked for.

    found : a :class:`~newton_euler.accuracy.precision.WorkPrecision`
    Returns the front of the methods by time; "auto", which only chooses one of them, is drawn over them.
    """
    figure.set_layout_engine("constrained")
    figure.set_size_inches(*SIZE)
    scene = found.scene
    figure.suptitle(f"{scene.name}, section {scene.section}: {scene.description}", fontsize=12)
    left, middle, right = figure.subplots(1, 3)
    points = [replace(p, error=max(p.error, FLOOR)) for p in found.points]
    methods, auto = [p for p in points if p.method != "auto"], [p for p in points if p.method == "auto"]
    best = chart(methods, left, order=NAMES, legend=False)
    chart([p for p in methods if p.calls], middle, cost="calls", order=NAMES, legend=False)
    for ax, cost, label in ((left, "cost", "time of a run"), (middle, "calls", "calls of the right-hand side")):
        ax.plot([getattr(p, cost) for p in auto], [p.error for p in auto], **AUTO)
        ax.set(xlabel=label, ylabel="true error at the end, relative" if ax is left else "")
    _draw_drift(methods, auto, right)
    handles, names = left.get_legend_handles_labels()
    figure.legend(handles, [_prepared(name, found) for name in names], loc="outside right center", frameon=False, fontsize=9, labelspacing=0.8)
    return best


def _prepared(name, found):
    """The method, and what its first run took more."""
    seconds, costs = found.preparing.get(name, 0.0), [p.cost for p in found.points if p.method == name]
    return f"{name}\n  {1e3 * seconds:.0f} ms to prepare" if seconds > max([2e-3, *costs[:1]]) else name  # less is noise


def _draw_drift(methods, auto, ax):
    known = [p for p in methods if p.drift is not None]
    ax.set_title("drift of the invariants" if known else "no invariant is known", fontsize=10)
    if not known:
        ax.set_axis_off()
        return
    for n, method in enumerate(NAMES):
        own = [p for p in known if p.method == method]
        ax.plot([p.asked for p in own], [max(p.drift, FLOOR) for p in own], ms=7, lw=0.8, **look(n))
    ax.plot([p.asked for p in auto], [max(p.drift, FLOOR) for p in auto], **AUTO)
    asked = sorted({p.asked for p in known})
    (diagonal,) = ax.plot(asked, asked, color="#999999", lw=1, ls=":")
    ax.legend([diagonal], ["drift = rtol"], loc="upper left", frameon=False, fontsize=9)
    ax.set(xscale="log", yscale="log", xlabel="error asked for, rtol", ylabel="worst drift of an invariant, relative")
    ax.grid(True, color="#dddddd", lw=0.6)
    ax.set_axisbelow(True)


# -- models


def measured_models(ladder, progress=None):
    """For each rung of a :class:`~newton_euler.ladders.Ladder` a :class:`~newton_euler.accuracy.Measured`: the time of its motion, and its error.

    The time is that of a run to 1e-9 which :func:`newton_euler.prepare` has made; the error is in the ladder's unit, that of the fullest rung 0.
    """
    points = []
    for n, rung in enumerate(ladder.rungs):
        if progress:
            progress(n / len(ladder.rungs), rung.name)
        error = ladder.error(rung)
        run, start = prepare(rung.model, 1e-9), tuple(map(float, rung.start))
        cost = timed(lambda: run(ladder.t, start), runs=5)  # noqa: B023 (called at once)
        points.append(Measured(rung.name, cost, error, asked=1e-9))
    return points


def draw_models(points, ladder, figure):
    """Error of each rung, in the ladder's unit, against the time of its motion; what the model itself bounds is a bar above. Returns the front.

    The fullest rung, which the others are measured against, stands below at the arrow.
    """
    figure.set_layout_engine("constrained")
    figure.set_size_inches(9.0, 5.6)
    ax = figure.subplots()
    floor = min((p.error for p in points if p.error), default=1.0) / 100
    best = chart(points, ax, floor=floor, legend=False)
    middle = math.sqrt(min(p.cost for p in points) * max(p.cost for p in points))
    for n, p in enumerate(points):
        beside = any(q.error and abs(math.log(q.cost / p.cost)) < 0.3 and q.error < 3 * p.error < 9 * q.error for q in points[:n])
        _draw_rung(ladder, p, max(p.error, floor), p.cost > middle, beside, ax)
    ax.set_title(f"models of {ladder.name}, until t = {ladder.t:g}: what they cost, and what they leave out", fontsize=11)
    ax.set(xlabel="time of a run to 1e-9", ylabel=f"error of {ladder.of}")
    ax.margins(x=0.2)
    ax.set_ylim(floor / 12, 30 * (max(p.error for p in points) or 1.0))  # bounds may be far beyond
    return best


def _draw_rung(ladder, point, height, dear, low, ax):
    bound = ladder.rung(point.method).bound(ladder.t)
    if point.error and bound < math.inf:
        ax.plot([point.cost] * 2, [height, bound], color="#999999", lw=1, marker="_", ms=10, zorder=1)
    place = {"xytext": (-12, -14), "ha": "right"} if dear else {"xytext": (12, -16 if low else 6)}  # low: another label is there
    ax.annotate(point.method.removeprefix(f"{ladder.name}, "), (point.cost, height), textcoords="offset points", fontsize=9, **place)
