"""Work-precision data of the methods on a scene: the time of each, and its error against 30 digits.

>>> found = work_precision("sphere on an incline", (1e-3, 1e-9), ("exact", "dop853", "auto"))
>>> max(p.error for p in found.points if p.method == "exact") < 1e-13
True
>>> max(p.drift for p in found.points) < 1e-13  # of the energy
True
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from importlib import import_module
from time import perf_counter

from ...motion.integration import integrate
from ...motion.methods.base import SMALLEST_SCALE
from ...motion.methods.table import METHODS
from ...motion.model import Model, ModelError
from ...motion.prepared import PreparedModel
from ...motion.solution import Motion
from ...scenes import scene as scene_named
from ...scenes.catalogue import Scene
from .measure import Measured, Progress, of_repeats, silent, timed, timings
from .reference import reference_solution

TOLERANCES = tuple(10.0**-n for n in range(3, 14))
QUICK = TOLERANCES[::2]
LONGEST = 0.2  # seconds; a method whose run takes longer is not asked for more digits
LONG = 0.03  # seconds; a longer run is timed once, a shorter one in many runs
NAMES = (*METHODS, "auto")
_PREPARATIONS: dict = {}  # seconds by scene and method, of the first run of this process
STEPPING, CLOSED = "stepping methods", "closed forms"  # the families


@dataclass(frozen=True)
class WorkPrecision:
    """What was measured on one scene. A method that the scene cannot use has no points.

    points : :class:`~newton_euler.accuracy.Measured`, method by method
    ratios : {tolerance: (time of "auto" / time of the cheapest other method that reached it, its
        name)}, measured in turns; not where "auto" takes the exact solution, whose time says
        nothing about methods that step
    preparing : {method: seconds by which its first run, which compiles, took longer than the next}
    too_slow, unable : {method: after which run it was left out}, or why it failed
    """

    scene: Scene
    points: tuple
    ratios: dict
    preparing: dict
    too_slow: dict
    unable: dict

    def explain(self) -> str:
        """The numbers as a table, then the ratios of "auto", and what was left out; a text."""
        lines = [f"  {'method':13} {'rtol':>6} {'time':>11} {'calls':>8} {'error':>8} {'drift':>8}"]
        for p in self.points:
            drift = "" if p.drift is None else f"{p.drift:.1e}"
            time = f"{p.method:13} {p.asked:6.0e} {1e6 * p.cost:8.1f} us"
            lines.append(f"  {time} {p.calls:8} {p.error:8.1e} {drift:>8}")
        for rtol, (ratio, best) in self.ratios.items():
            lines.append(f"  auto, asked for {rtol:.0e}: {ratio:.2f} times the time of {best}")
        if any(p.method == "auto" and p.family == CLOSED for p in self.points):
            lines.append("  auto takes the exact solution")
        left_out = {**self.too_slow, **self.unable}
        return "\n".join(lines + [f"  {method}: {why}" for method, why in left_out.items()])

    __str__ = explain


def work_precision(
    name: str,
    tolerances: Sequence[float] = TOLERANCES,
    methods: Sequence[str] = NAMES,
    longest: float = LONGEST,
    progress: Progress = silent,
) -> WorkPrecision:
    """The :class:`WorkPrecision` of a scene: every method it can use, at every tolerance. The cost
    is the time of ``integrate`` after its model is prepared and its code compiled, the error that
    of the worst state at the end, as in :class:`~newton_euler.motion.solution.Motion`.

    longest : a method whose run takes more seconds is not asked for more digits
    """
    scene = scene_named(name)
    reference = Reference(scene)
    points: list = []
    preparing: dict = {}
    too_slow: dict = {}
    unable: dict = {}
    for n, method in enumerate(methods):
        for m, rtol in enumerate(tolerances if can_use(method, reference.model) else ()):
            progress((n + m / len(tolerances)) / len(methods), f"{method}, {rtol:.0e}")
            try:
                point, first = reference.measured(method, rtol)
            # the method cannot reach this tolerance, or not on this scene
            except ModelError as error:
                unable[method] = f"{rtol:.0e}: {error}"
                break
            if method not in preparing:
                more = first - point.cost if first > 2 * point.cost else 0.0  # else maybe noise
                preparing[method] = _PREPARATIONS.setdefault((name, method), more)
                point = replace(point, prepared=preparing[method])
            points.append(point)
            if point.cost > longest and rtol != tolerances[-1]:
                took = f"{rtol:.0e}, which took {point.cost:.2g} s"
                too_slow[method] = f"not asked for less than {took}"
                break
    ratios = dict(_ratios(reference, points))
    return WorkPrecision(scene, tuple(points), ratios, preparing, too_slow, unable)


def _ratios(reference, points):
    stepped = {p.asked for p in points if p.method == "auto" and p.family != CLOSED}
    for rtol in sorted(stepped, reverse=True):
        reached = [p for p in points if p.asked == rtol and p.error <= rtol and p.method != "auto"]
        if reached:
            best = min(reached, key=lambda p: p.cost).method
            runs = [partial(reference.run, method, rtol) for method in ("auto", best)]
            auto, other = timed(*runs, runs=15, shortest=5e-4)
            yield rtol, (auto / other, best)


def can_use(method: str, model: Model) -> bool:
    """Whether a method integrates this model."""
    return method == "auto" or not METHODS[method].unusable_because(PreparedModel(model))


class Reference:
    """The final state of a scene to 30 digits, against which the errors of methods are taken."""

    def __init__(self, scene: Scene):
        import_module("scipy.integrate")  # imports are not what is measured
        self.model, self.t, self.start = scene.motion
        self.end, self.sizes = final_state(scene), state_sizes(scene)

    def run(self, method: str, rtol: float) -> Motion:
        """The motion of the scene by a method."""
        motion = integrate(self.model, self.t, self.start, rtol, method)
        assert isinstance(motion, Motion)
        return motion

    def error(self, motion: Motion) -> float:
        """The true error of the last state, as ``Motion.error`` counts it."""
        states = zip(self.model.states, self.end, self.sizes, strict=True)
        return max(abs(motion.end[n] - x) / size for n, x, size in states)

    def measured(self, method: str, rtol: float) -> tuple[Measured, float]:
        """The point of one method at one tolerance, and the seconds that its first run took."""
        motion, repeats, first = timed_run(partial(self.run, method, rtol), method)
        numbers = rtol, motion.cost.calls, worst_drift(motion)
        family = CLOSED if motion.method.closed else STEPPING
        point = Measured(method, first, self.error(motion), f"rtol = {rtol:.0e}", *numbers, family)
        return replace(point, **of_repeats(repeats)), first


def worst_drift(motion: Motion) -> float | None:
    """The largest drift of an invariant at some hundred ends of steps; None without invariants."""
    ends = motion.segments[0].stepper.step_times
    sampled = replace(motion, samples=ends[:: len(ends) // 100 + 1]) if len(ends) > 100 else motion
    return max(sampled.drift.values(), default=None)


def timed_run(run: Callable[[], Motion], method: str) -> tuple[Motion, Sequence[float], float]:
    """What a run by a method returns, the seconds of each of some runs, and those of the first."""
    result, first = _stopwatch(run)
    repeats: tuple[float, ...] = (first,)
    # a long first run is not repeated, unless it may have compiled code
    if first <= LONGEST or method == "auto" or METHODS[method].closed or METHODS[method].series:
        repeats = (_stopwatch(run)[1],)
        if repeats[0] <= LONG:
            (repeats,) = timings([run])
    return result, repeats, first


def _stopwatch(call):
    begun = perf_counter()
    return call(), perf_counter() - begun


@cache
def final_state(scene: Scene) -> tuple[float, ...]:
    """The last state by :func:`.reference_solution`, rounded to floats."""
    return tuple(map(float, reference_solution(*scene.motion)))


@cache
def state_sizes(scene: Scene) -> tuple[float, ...]:
    """The largest size of each state, at least 1e-6, to which errors are relative."""
    model, t, start = scene.motion
    # not by its exact solution, which gives no steps between
    motion = integrate(replace(model, exact=None), t, start, 1e-6, "dop853")
    return tuple(max(float(abs(x).max()), SMALLEST_SCALE) for x in motion.states.values())
