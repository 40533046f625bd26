"""One integration of one motion: which method is used, how its tolerance is chosen, and how its
error is estimated.
"""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from time import perf_counter
from typing import Any

from .events import Event
from .methods.table import COARSENING, MAX_COARSE_TOLERANCE, METHODS
from .methods.taylor import ShortSteps
from .model import ModelError
from .solution import Cost, Motion, MotionError
from .trajectory import Trajectory

# seconds of integrating one right-hand side, after which heyoka's import and compilation would have
# been earned back
HEYOKA_BREAK_EVEN = 0.5
MAX_REFINEMENTS = 5  # of the tolerance
SAFETY_FACTOR = 4.0  # on the error that the difference of two runs predicts
# part of the error that the difference of two runs does not show; that of a short run, and over n
# steps it grows as sqrt(n), as a random walk
ROUND_OFF = 2e-14
SHORT_TAYLOR = replace(METHODS["taylor"], stepper=ShortSteps)


def span(t):
    """The times of start and end as floats; a single number is the end, with the start at 0."""
    if type(t) is float and 0.0 < t < math.inf:
        return 0.0, t
    try:
        t0, t1 = map(float, t) if hasattr(t, "__iter__") else (0.0, float(t))
    except (TypeError, ValueError) as error:
        raise ModelError(f"t is the time at which to end, or (from, to); got {t!r}") from error
    if not (math.isfinite(t0) and math.isfinite(t1) and t0 < t1):
        raise ModelError(f"time runs forward: the end is after the start, got {t0!r} to {t1!r}")
    return t0, t1


def check(rtol, method, events=(), step=None):
    """Raise :class:`ModelError` for arguments with which no model can be integrated."""
    if method != "auto" and method not in METHODS:
        names = ", ".join(METHODS)
        raise ModelError(f"there is no method {method!r}; take 'auto' or one of {names}")
    least = 1e-15 if method == "auto" else METHODS[method].min_rtol
    number = isinstance(rtol, (int, float))
    if step is None and not (number and least <= rtol < 1):
        why = "it lies below 1"
        if number and 0 < rtol < 1:
            why = f"method {method!r} cannot reach it, the least is {least:g}"
        raise ModelError(f"rtol is the error asked for, got {rtol!r}: {why}")
    for event in events:
        if not isinstance(event, Event):
            raise ModelError(f"events are made by Event(...), got {event!r}")
    if step is not None and not step > 0:
        raise ModelError(f"the step is a positive time, got {step!r}")


def usable(name, system, t0=0.0):
    """The method of this name; :class:`ModelError` if it cannot be used for the model from this
    start time on.
    """
    why = METHODS[name].unusable_because(system, t0)
    if why:
        raise ModelError(f"method {name!r} cannot be used: {why}")
    return METHODS[name]


@dataclass(eq=False)
class Run:
    """The arguments of one integration; :meth:`by_name` returns the
    :class:`~newton_euler.motion.solution.Motion`.
    """

    system: Any
    t0: float
    t1: float
    state: tuple
    rtol: float
    events: tuple = ()
    samples: Any = None
    progress: Callable | None = None
    step: float | None = None
    preparing: float = 0.0
    calls: int = 0
    started: float = field(default_factory=perf_counter)

    def by_name(self, name):
        """The motion by the method of this name, or by the one that "auto" chooses."""
        if name == "auto":
            if self.step:
                raise ModelError("a fixed step needs a method by name")
            return self.auto()
        method = usable(name, self.system, self.t0)
        if not self.step:
            return self.by(method)
        if method.order is None:
            raise ModelError(f"method {name!r} has no fixed step")
        return self.motion(self.trajectory(method, self.rtol), method, math.nan)

    def trajectory(self, method, tolerance, scales=None):
        """The trajectory at one tolerance."""
        trajectory = Trajectory(self, method, tolerance, scales)
        self.calls += trajectory.calls
        return trajectory

    def motion(self, trajectory, method, error):
        """The :class:`~newton_euler.motion.solution.Motion` of a trajectory; raises
        :class:`~newton_euler.motion.solution.MotionError` if that failed.
        """
        cost = Cost(perf_counter() - self.started, self.preparing, self.calls)
        parts, occurrences = tuple(trajectory.segments), tuple(trajectory.occurrences)
        model, ended = self.system.model, trajectory.ended
        motion = Motion(
            model, parts, occurrences, method, self.rtol, ended, cost, self.samples, error
        )
        if trajectory.failed:
            raise MotionError(f"{ended}; see .reached of this error", motion)
        return motion

    def auto(self):
        """The motion by the exact solution if there is one, else by heyoka if its compilation has
        been or will be earned back, else by DOP853.
        """
        system, taylor, dop853 = self.system, METHODS["taylor"], METHODS["dop853"]
        if not METHODS["exact"].unusable_because(system, self.t0):
            try:
                return self.by(METHODS["exact"])
            except ModelError:
                pass  # it has no value for this start or is not accurate: there are other methods
        heyoka, tight = not taylor.unusable_because(system), self.rtol < dop853.min_rtol
        traced = system.traced
        if heyoka and (tight or traced.integrators or traced.seconds > HEYOKA_BREAK_EVEN):
            try:
                return self.by(taylor)
            # as where the rates are not analytic: |v| v at rest, which Runge-Kutta methods can pass
            except MotionError:
                if tight:
                    raise
                heyoka = False
        if tight:
            least = f"without it the least is {dop853.min_rtol:g}"
            raise ModelError(f"rtol = {self.rtol:g} needs heyoka, which is not installed; {least}")
        return self.calibrated(dop853, heyoka)

    def by(self, method):
        """The motion by one method within rtol."""
        if method.calibrated:
            return self.calibrated(method)
        trajectory = self.trajectory(method, self.rtol / method.tolerance_ratio)
        if method.name == "exact":
            self.verify_exact(trajectory)
            return self.motion(trajectory, method, trajectory.exact_error)

        def error():
            """From a second run with shorter steps, which is much more accurate; plus round-off."""
            self.progress = None
            shorter = self.trajectory(SHORT_TAYLOR, trajectory.tolerance)
            return 2 * trajectory.difference(shorter) + 2e-15

        return self.motion(trajectory, method, error)

    def verify_exact(self, trajectory):
        """Raise :class:`ModelError` where the exact solution is wrong: the first one of a model is
        compared with itself, see :meth:`Trajectory.exact_error`; after that it is trusted.

        For later ones this comparison is the ``error`` of the motion, made when that is asked for.
        """
        if len(trajectory.segments) == 1 and self.system.exact_verified:
            return
        error = trajectory.exact_error()
        self.system.exact_verified = error is not None and error <= self.rtol
        if not self.system.exact_verified:
            why = "it becomes a model without one"
            if error is not None:
                why = f"it is not accurate here: its error is about {error:.1g}"
            raise ModelError(
                f"the closed form of {self.system.model.name!r} does not do: {why}; take "
                "method='auto'"
            )

    def calibrated(self, method, heyoka=False):
        """The motion by two runs or more, see :mod:`newton_euler.motion.methods.table`; with
        ``heyoka`` by heyoka if the first run shows that the second would take long.
        """
        begun, least = perf_counter(), method.min_tolerance
        tolerance = max(min(self.rtol / method.tolerance_ratio, method.max_tolerance), least)
        coarse = min(tolerance * COARSENING, MAX_COARSE_TOLERANCE)
        before = self.trajectory(method, coarse)
        # of order 8: the number of steps grows as tolerance**(-1/8)
        if heyoka and (perf_counter() - begun) * (coarse / tolerance) ** 0.125 > HEYOKA_BREAK_EVEN:
            with suppress(MotionError):
                return self.by(METHODS["taylor"])
        for _ in range(MAX_REFINEMENTS + 1):
            trajectory = self.trajectory(method, tolerance, before.scales)
            error = predicted_error(before, trajectory)
            if error <= self.rtol or tolerance <= least or trajectory.failed:
                break
            # error and tolerance are proportional; a third of the rtol, as the prediction is rough
            finer = max(tolerance * max(1 / COARSENING, self.rtol / error / 3), least)
            before, tolerance = trajectory, min(finer, tolerance / 4)
        self.system.traced.seconds += perf_counter() - begun
        return self.motion(trajectory, method, error)


def predicted_error(before, trajectory):
    """The error of a trajectory, predicted from its difference to one of coarser tolerance."""
    difference = before.difference(trajectory)
    if difference > 0.05:
        return difference  # the coarse one is too far off to predict anything
    steps = sum(len(segment.stepper.step_times) for segment in trajectory.segments)
    predicted = SAFETY_FACTOR * difference * trajectory.tolerance / before.tolerance
    return predicted + ROUND_OFF * math.sqrt(1 + steps / 100)
