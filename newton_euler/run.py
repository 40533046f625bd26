"""One integration of one motion: which method is used, how its tolerance is chosen, and how its error is estimated."""

import math
from contextlib import suppress
from dataclasses import replace
from time import perf_counter

from .events import Event
from .journeys import Trajectory
from .methods import COARSENING, MAX_COARSE_TOLERANCE, METHODS
from .models import ModelError
from .records import Cost, Motion, MotionError
from .taylor import ShortSteps

HEYOKA_BREAK_EVEN = 0.5  # seconds of integrating one right-hand side, after which heyoka's import and compilation would have been earned
MAX_REFINEMENTS = 5
SAFETY_FACTOR = 4.0  # times the error that the difference foretells
MIN_ERROR_ESTIMATE = 2e-14  # no estimate is smaller
SHORT_TAYLOR = replace(METHODS["taylor"], stepper=ShortSteps)


def span(t):
    """The times of start and end as floats: a number is the end, after a start at 0."""
    if type(t) is float and 0.0 < t < math.inf:
        return 0.0, t
    try:
        t0, t1 = map(float, t) if hasattr(t, "__iter__") else (0.0, float(t))
    except (TypeError, ValueError) as error:
        raise ModelError(f"t is the time at which to end, or a pair (from, to); got {t!r}") from error
    if not (math.isfinite(t0) and math.isfinite(t1) and t0 < t1):
        raise ModelError(f"time runs forward: the end must come after the start, got from {t0!r} to {t1!r}")
    return t0, t1


def check(rtol, method, events=(), step=None):
    """Raise :class:`ModelError` for what no model could be integrated with."""
    if method != "auto" and method not in METHODS:
        raise ModelError(f"there is no method {method!r}; take 'auto' or one of {', '.join(METHODS)}")
    min_rtol = 1e-15 if method == "auto" else METHODS[method].min_rtol
    if step is None and not (isinstance(rtol, (int, float)) and min_rtol <= rtol < 1):
        what = (
            f"method {method!r} cannot reach it, the least is {min_rtol:g}" if isinstance(rtol, (int, float)) and 0 < rtol < 1 else "it lies below 1"
        )
        raise ModelError(f"rtol is the error asked for, got {rtol!r}: {what}")
    for event in events:
        if not isinstance(event, Event):
            raise ModelError(f"events are made by Event(function, direction, ...), got {event!r}")
    if step is not None and not step > 0:
        raise ModelError(f"the step is a positive time, got {step!r}")


def usable(name, system, t0=0.0):
    """The method of this name, if it can be used for the model from this time on."""
    if name == "auto":
        raise ModelError("a fixed step needs a method by name")
    failed = METHODS[name].unusable_because(system)
    if name == "exact" and t0 and not system.autonomous:
        failed = f"the rates of {system.model.name!r} depend on time, so its exact solution starts at t = 0"
    if failed:
        raise ModelError(f"method {name!r} cannot be used: {failed}")
    return METHODS[name]


def cheapest(system, rtol):
    """The name of the method without a closed form that costs least: heyoka's, once its compilation has been or will be earned back."""
    taylor, min_rtol = METHODS["taylor"], METHODS["dop853"].min_rtol
    if not taylor.unusable_because(system) and (system.traced.integrators or system.traced.seconds > HEYOKA_BREAK_EVEN or rtol < min_rtol):
        return "taylor"
    if rtol < min_rtol:
        raise ModelError(f"rtol = {rtol:g} needs heyoka, which is not installed; without it the least is {min_rtol:g}")
    return "dop853"


class Run:
    """What is asked of an integration, and the ways to answer it; each returns a :class:`~newton_euler.records.Motion`."""

    def __init__(self, system, t0, t1, state, rtol, events=(), samples=None, progress=None, step=None, begun=None):
        self.system, self.t0, self.t1, self.state, self.rtol = system, t0, t1, state, rtol
        self.events, self.samples, self.progress, self.step = events, samples, progress, step
        self.calls, self.prepared = 0, perf_counter()
        self.preparing = self.prepared - begun if begun else 0.0

    def by_name(self, name):
        """By the method of this name, or the one that "auto" takes."""
        if self.step:
            return self.fixed(usable(name, self.system))
        return self.auto() if name == "auto" else self.by(usable(name, self.system, self.t0))

    def go(self, method, tolerance, scales=None):
        """One run; SciPy or heyoka are imported and compiled on the way, which is not counted as integrating."""
        trajectory = Trajectory(self, method, tolerance, scales)
        self.calls += trajectory.calls
        return trajectory

    def record(self, trajectory, method, error):
        cost = Cost(perf_counter() - self.prepared, self.preparing, self.calls)
        segments, occurrences = tuple(trajectory.segments), tuple(trajectory.occurrences)
        motion = Motion(self.system.model, segments, occurrences, method, self.rtol, trajectory.ended, cost, self.samples, error)
        if trajectory.failed:
            raise MotionError(f"{trajectory.ended}; what was reached is in the error's .reached", motion)
        return motion

    # -- by method

    def auto(self):
        exact, taylor, dop853 = METHODS["exact"], METHODS["taylor"], METHODS["dop853"]
        if exact.unusable_because(self.system) is None and (self.t0 == 0 or self.system.autonomous):
            try:
                return self.by(exact)
            except ModelError:  # it refuses this start in words, or is not accurate: there are other methods
                pass
        heyoka = not taylor.unusable_because(self.system)
        if cheapest(self.system, self.rtol) == "taylor":
            try:
                return self.by(taylor)
            except MotionError:  # as where the rates are not analytic: |v| v at rest; Runge-Kutta methods do not mind
                if self.rtol < dop853.min_rtol:
                    raise
                heyoka = False
        return self.calibrated(dop853, heyoka)

    def by(self, method):
        if method.calibrated:
            return self.calibrated(method)
        trajectory = self.go(method, self.rtol / method.tolerance_ratio)
        if method.name == "exact":
            self.check_exact(trajectory)
            return self.record(trajectory, method, trajectory.exact_error)

        def error():
            self.progress = None
            return 2 * trajectory.difference(self.go(SHORT_TAYLOR, trajectory.tolerance)) + 2e-15

        return self.record(trajectory, method, error)

    def check_exact(self, trajectory):
        """Raise :class:`ModelError` where an exact solution is none: the first of a model is tried by going half of the way twice, and then trusted.

        Of every motion this is its ``error``, when that is asked for.
        """
        if len(trajectory.segments) == 1 and self.system.exact_verified:
            return
        error = trajectory.exact_error()
        self.system.exact_verified = error is not None and error <= self.rtol
        if not self.system.exact_verified:
            why = "it becomes a model without one" if error is None else f"it is not accurate here: its error is about {error:.1g}"
            raise ModelError(f"the closed form of {self.system.model.name!r} does not do: {why}; take method='auto'")

    def fixed(self, method):
        if method.order is None:
            raise ModelError(f"method {method.name!r} has no fixed step")
        return self.record(self.go(method, self.rtol), method, math.nan)

    def calibrated(self, method, heyoka=False):
        """Two runs or more, as :mod:`.methods` says."""
        begun = perf_counter()
        tolerance = max(min(self.rtol / method.tolerance_ratio, method.max_tolerance), method.min_tolerance)
        coarse = min(tolerance * COARSENING, MAX_COARSE_TOLERANCE)
        before = self.go(method, coarse)
        if heyoka and (perf_counter() - begun) * (coarse / tolerance) ** 0.125 > HEYOKA_BREAK_EVEN:
            with suppress(MotionError):
                return self.by(METHODS["taylor"])
        for _ in range(MAX_REFINEMENTS + 1):
            trajectory = self.go(method, tolerance, before.scales)
            error = predicted_error(before, trajectory)
            if error <= self.rtol or tolerance <= method.min_tolerance or trajectory.failed:
                break
            finer = max(tolerance * max(1 / COARSENING, self.rtol / error / 3), method.min_tolerance)
            before, tolerance = trajectory, min(finer, tolerance / 4)
        self.system.traced.seconds += perf_counter() - begun
        return self.record(trajectory, method, error)


def predicted_error(before, trajectory):
    """The error of a run from its difference to one of coarser tolerance."""
    difference = before.difference(trajectory)
    if difference > 0.05:
        return difference  # the coarse one is too far off to foretell anything
    steps = sum(len(segment.stepper.step_times) for segment in trajectory.segments)
    return SAFETY_FACTOR * difference * trajectory.tolerance / before.tolerance + MIN_ERROR_ESTIMATE * math.sqrt(1 + steps / 100)
