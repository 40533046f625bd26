"""Work and precision of the methods of integration on a scene: what each costs, and how far it is off from 30 digits.

>>> found = work_precision("sphere on an incline", tolerances=(1e-3, 1e-9), methods=("exact", "dop853", "auto"))
>>> [p.error < 1e-13 for p in found.points if p.method == "exact"]
[True, True]
>>> max(p.drift for p in found.points) < 1e-13  # of the energy
True
"""

from dataclasses import dataclass, replace
from functools import cache
from importlib import import_module
from time import perf_counter

from ..courses import SMALLEST_SCALE
from ..methods import METHODS
from ..models import ModelError
from ..motion import integrate
from ..systems import PreparedModel
from . import Measured, catalogue, timed
from .reference import reference

TOLERANCES = tuple(10.0**-n for n in range(3, 14))
QUICK = TOLERANCES[::2]
LONGEST = 0.2  # seconds that a run may take; a method is not asked for more digits after that
LONG = 0.03  # a run that takes longer is timed by itself, not in many runs
TURNS = 15  # in which times are compared
NAMES = (*METHODS, "auto")


@dataclass(frozen=True)
class WorkPrecision:
    """What was measured on one scene.

    scene : a :class:`~newton_euler.accuracy.catalogue.Scene`
    points : :class:`~newton_euler.accuracy.Measured`, method by method, each with what was ``asked`` for
    ratios : by tolerance, how many times the time of the cheapest other method "auto" takes, measured in turns, and the name of that method; it was
        asked for the same and reached it
    preparing : seconds by method that its first run took more than the next, to write and compile code; all imports were made before
    left_out : by method, in words, why it was not asked for the smallest tolerances; methods that the scene cannot use have no points
    """

    scene: catalogue.Scene
    points: tuple
    ratios: dict
    preparing: dict
    left_out: dict

    def explain(self):
        """The numbers as a table; then the ratios of "auto", and what was left out."""
        lines = [f"  {'method':13} {'rtol':>6} {'time':>11} {'calls':>8} {'error':>8} {'drift':>8}"]
        for p in self.points:
            drift = "" if p.drift is None else f"{p.drift:.1e}"
            lines.append(f"  {p.method:13} {p.asked:6.0e} {1e6 * p.cost:8.1f} us {p.calls:8} {p.error:8.1e} {drift:>8}")
        lines += [f"  auto, asked for {rtol:.0e}: {ratio:.2f} times the time of {best}" for rtol, (ratio, best) in self.ratios.items()]
        return "\n".join(lines + [f"  {method}: {why}" for method, why in self.left_out.items()])

    __str__ = explain


def work_precision(name, tolerances=TOLERANCES, methods=NAMES, longest=LONGEST, progress=None):
    """Measure every method that the scene can use at every tolerance: a :class:`WorkPrecision`.

    The cost is the time of one call of ``integrate``, its model prepared and its code compiled before. The error is that of the worst state at
    the end, relative to its largest size on the way, as :class:`~newton_euler.records.Motion` counts it.

    longest : a method whose run takes more seconds is not asked for more digits
    progress : a function ``(fraction, words)``, called now and then
    """
    scene = catalogue.scene(name)
    judge = Judge(scene)
    points, preparing, left_out = [], {}, {}
    for n, method in enumerate(methods):
        if method != "auto" and METHODS[method].unusable_because(PreparedModel(judge.model)):
            continue
        for m, rtol in enumerate(tolerances):
            if progress:
                progress((n + m / len(tolerances)) / len(methods), f"{method}, {rtol:.0e}")
            try:
                point, first = judge.measured(method, rtol)
            except ModelError as error:  # it cannot reach so much, or not here
                left_out[method] = f"{rtol:.0e}: {error}"
                break
            points.append(point)
            preparing.setdefault(method, max(first - point.cost, 0.0))
            if point.cost > longest and m + 1 < len(tolerances):
                left_out[method] = f"not asked for less than {rtol:.0e}, which took {point.cost:.2g} s"
                break
    return WorkPrecision(scene, tuple(points), dict(_ratios(judge, points)), preparing, left_out)


def _ratios(judge, points):
    """Of each tolerance the cheapest method that was asked for it and reached it, and how many times its time "auto" takes, measured in turns."""
    for rtol in sorted({p.asked for p in points if p.method == "auto"}, reverse=True):
        reached = [p for p in points if p.asked == rtol and p.error <= rtol and p.method != "auto"]
        if reached:
            best = min(reached, key=lambda p: p.cost).method
            ours, theirs = timed(lambda: judge.run("auto", rtol), lambda: judge.run(best, rtol), runs=TURNS, shortest=5e-4)  # noqa: B023
            yield rtol, (ours / theirs, best)


class Judge:
    """A scene with its reference: it runs methods on it and says how far they are off."""

    def __init__(self, scene):
        import_module("scipy.integrate")  # imports are not what is measured
        self.scene = scene
        self.model, self.t, self.start = scene.motion
        self.end = known(scene)
        self.sizes = sizes(scene)

    def run(self, method, rtol):
        """The motion."""
        return integrate(self.model, self.t, self.start, rtol, method)

    def error(self, motion):
        """The true error of the last state, as ``Motion.error`` counts it."""
        return max(abs(motion.end[n] - x) / size for n, x, size in zip(self.model.states, self.end, self.sizes, strict=True))

    def measured(self, method, rtol):
        """The point of one method at one tolerance, and the seconds that its first run took."""
        begun = perf_counter()
        motion = self.run(method, rtol)
        first = perf_counter() - begun
        compiles = method == "auto" or not METHODS[method].calibrated
        cost = first if first > LONGEST and not compiles else _seconds(lambda: self.run(method, rtol))
        return Measured(method, cost, self.error(motion), f"rtol = {rtol:.0e}", rtol, motion.cost.calls, worst_drift(motion)), first


def worst_drift(motion):
    """The largest drift of an invariant, at about a hundred ends of steps; None if no invariant is known."""
    ends = motion.segments[0].stepper.step_times
    sampled = replace(motion, samples=ends[:: len(ends) // 100 + 1]) if len(ends) > 100 else motion
    return max(sampled.drift.values(), default=None)


def _seconds(call):
    begun = perf_counter()
    call()
    once = perf_counter() - begun
    return once if once > LONG else timed(call, runs=3, shortest=1e-3)


@cache
def known(scene):
    """The last state by :func:`~newton_euler.accuracy.reference.reference`, rounded to floats."""
    return tuple(map(float, reference(*scene.motion)))


@cache
def sizes(scene):
    """The largest size of each state on the way, at least 1e-6: what errors are relative to."""
    model, t, start = scene.motion
    motion = integrate(replace(model, exact=None), t, start, 1e-6, "dop853")
    return tuple(max(float(abs(x).max()), SMALLEST_SCALE) for x in motion.states.values())
