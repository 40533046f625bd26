"""One integration of one motion: which method is used, how its tolerance is chosen, and how its
error is estimated and compared with what was asked for.
"""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from time import perf_counter
from typing import Any

from .events import Event, EventError
from .knots import knots
from .methods.base import MAX_STEPS, LengthError
from .methods.exact import Exact, estimated_error, within
from .methods.table import METHODS
from .methods.taylor import level_of
from .model import ModelError
from .sizes import time_round_off
from .solution import AccuracyError, Cost, Motion, MotionError
from .trajectory import Trajectory

# seconds of integrating one right-hand side, after which heyoka's import and compilation would have
# been earned back
HEYOKA_BREAK_EVEN = 0.5
FEW_STEPS = 1e5  # of a motion whose closed form is not accurate enough
SIZE_SAMPLES = 33  # instants at which the size of the states is looked at
MAX_REFINEMENTS = 5  # of the tolerance
# A run is compared with one of a coarser tolerance. If both are in the regime in which errors are
# proportional to the tolerance, the error of the fine one is predicted by a power of the ratio of
# the tolerances a little below 1; else, as at kinks, by a low power. Measured by tests/honesty on
# 115 models, at 1e-3 to 1e-12: these cover 98 % of the true errors, and are 15 times too large in
# the median.
SAFETY, REGULAR, IRREGULAR = 7.0, 0.9, 0.4
TOLD_SAFETY = 3.0  # on the error that is told: with it 99 % are covered
# on the difference of a run of heyoka from one of higher order, which is its error, and on the
# integral of the residual of a series that may not see all of the rates
SERIES_SAFETY = RESIDUAL_SAFETY = 3.0
# the regime: so many steps at the least, and not more or fewer in the fine run than its order gives
MIN_STEPS, STEPS_OFF = 8, 1.25
# part of the error that the difference of two runs does not show; that of a short run, and over n
# steps it grows as sqrt(n), as a random walk
ROUND_OFF, SERIES_ROUND_OFF = 5e-14, 9e-15
# The coarse run starts a little beside the start, so that the error that is predicted contains what
# round-off in the rates, by 25 times a float's epsilon, makes of the end; it is the same in both
# runs, as that of the start and of parameters is.
ROUND_OFF_OF_RATES = 5e-15


def span(t):
    """The times of start and end as floats; a single number is the end, with the start at 0."""
    if type(t) is float and 0.0 < t < math.inf:
        return 0.0, t
    try:
        if isinstance(t, (str, bytes, bool)):
            raise TypeError
        t0, t1 = map(float, t) if hasattr(t, "__iter__") else (0.0, float(t))
    except (TypeError, ValueError) as error:
        raise ModelError(f"t is the time at which to end, or (from, to); got {t!r}") from error
    if not (math.isfinite(t0) and math.isfinite(t1) and t0 < t1):
        raise ModelError(f"time runs forward: the end is after the start, got {t0!r} to {t1!r}")
    return t0, t1


def check(rtol, method, events=(), step=None, progress=None):
    """Raise :class:`ModelError` for arguments with which no model can be integrated."""
    if method != "auto" and not (isinstance(method, str) and method in METHODS):
        names = ", ".join(METHODS)
        raise ModelError(f"there is no method {method!r}; take 'auto' or one of {names}")
    least = 1e-15 if method == "auto" else METHODS[method].min_rtol
    number = isinstance(rtol, (int, float))  # True and False lie outside
    if step is None and not (number and least <= rtol < 1):
        why = "it lies below 1"
        if number and 0 < rtol < 1:
            why = f"method {method!r} cannot reach it, the least is {least:g}"
        raise ModelError(f"rtol is the error asked for, got {rtol!r}: {why}")
    for event in events:
        if not isinstance(event, Event):
            raise ModelError(f"events are made by Event(...), got {event!r}")
    if step is not None and not (type(step) in (int, float) and 0 < step < math.inf):
        raise ModelError(f"the step is a positive time, got {step!r}")
    if progress is not None and not callable(progress):
        raise ModelError(f"progress is a function of the fraction that is done, got {progress!r}")


def checked_samples(samples, t0, t1):
    """The samples as they were given, None, a number of times, or as an array of times;
    :class:`ModelError` for anything else, and for times outside those of the motion.
    """
    if samples is None or (type(samples) is int and samples > 0):
        return samples
    import numpy as np

    what = "samples are a number of times, or times"
    try:
        given = list(samples) if hasattr(samples, "__next__") else samples
        times = np.array(given, dtype=float)
    except (TypeError, ValueError) as error:
        raise ModelError(f"{what}, got {samples!r}") from error
    if times.ndim != 1 or not len(times):
        raise ModelError(f"{what}, got {samples!r}")
    outside = times[~((times >= t0) & (times <= t1))]
    if len(outside):
        raise ModelError(
            f"{what} from t = {t0:g} to {t1:g}, where the motion is asked for; got "
            f"{outside[0]:g} among them"
        )
    return times


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
    max_steps: float = MAX_STEPS
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

    def trajectory(self, method, tolerance, *more):
        """The trajectory at one tolerance."""
        trajectory = Trajectory(self, method, tolerance, *more)
        self.calls += trajectory.calls
        return trajectory

    def compared(self, method, tolerance, fine, *more):
        """The trajectory at a tolerance, with which one at the tolerance ``fine`` is compared; it
        starts a little beside the start.
        """
        shift = ROUND_OFF_OF_RATES / SERIES_SAFETY
        if tolerance > fine:
            shift = ROUND_OFF_OF_RATES / (SAFETY * (fine / tolerance) ** REGULAR)
        if self.events:  # the start may lie on the surface of one
            shift = 0.0
        state = [x * (1 + (-shift if n % 2 else shift)) for n, x in enumerate(self.state)]
        trajectory = Trajectory(replace(self, state=tuple(state)), method, tolerance, *more)
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
        been or will be earned back, else by DOP853; where one cannot reach what was asked for, by
        the other.
        """
        refused = []
        if not METHODS["exact"].unusable_because(self.system, self.t0):
            try:
                return self.by(METHODS["exact"])
            except EventError:
                raise
            except AccuracyError as error:
                refused.append(error)
                # after a long time no method is much better, but each takes minutes
                self.max_steps = FEW_STEPS
            except ModelError:
                pass  # it has no value for this start, or its model changes: there are others
        for method, heyoka in self.candidates():
            try:
                return self.calibrated(method, True) if heyoka else self.by(method)
            except MotionError as error:
                # a series ends where rates are not analytic, which Runge-Kutta methods can pass
                if method.name != "taylor" and not refused and type(error) is MotionError:
                    raise
                refused.append(error)
        known = [error for error in refused if type(error) is AccuracyError] or refused
        raise min(known, key=lambda error: error.reached.error)

    def candidates(self):
        """The methods that "auto" tries, in order, each with True if the first run may show that
        heyoka would be faster.
        """
        system, taylor, dop853 = self.system, METHODS["taylor"], METHODS["dop853"]
        missing, tight = taylor.unusable_because(system), self.rtol < dop853.min_rtol
        if tight and missing:
            raise ModelError(
                f"rtol = {self.rtol:g} needs heyoka, without which the least is "
                f"{dop853.min_rtol:g}; {missing}"
            )
        traced = system.traced
        # what a series may not notice is left to a method that does
        if missing or (traced.hazards and not tight):
            return [(dop853, False)]
        if tight:
            return [(taylor, False)]
        if traced.integrators or traced.seconds > HEYOKA_BREAK_EVEN:
            return [(taylor, False), (dop853, False)]
        return [(dop853, True), (taylor, False)]

    def by(self, method):
        """The motion by one method within rtol."""
        if method.name == "exact":
            return self.closed(method)
        if method.name == "taylor" and not self.system.traced.hazards:
            return self.series(method)
        return self.calibrated(method)

    def series(self, method):
        """The motion by one run of heyoka on the states as they are, if that is enough; else with
        all care.

        The run is compared with a coarser one, unless a run close to it was.
        """
        trajectory = self.trajectory(method, self.rtol / method.tolerance_ratio)
        if not trajectory.failed:
            verified = self.system.verified
            ends = self.t0, self.t1, self.state, trajectory.segments[-1].x1
            if not self.events and verified.covers(self.rtol, *ends):
                later = partial(self.series_error, method, trajectory)
                return self.motion(trajectory, method, lambda: told(later(), self.rtol))
            error = self.series_error(method, trajectory)
            if error <= self.rtol:
                if not self.events:  # at which it may have ended before its time, or jumped
                    verified.add(self.rtol, *ends, error)
                return self.motion(trajectory, method, told(error, self.rtol))
        return self.calibrated(method)

    def series_error(self, method, trajectory):
        """The error of a run of heyoka, by one of higher order."""
        self.progress = None
        fine = trajectory.tolerance
        other = self.compared(method, method.other(fine), fine, None, False, SIZE_SAMPLES)
        return predicted_error(other, trajectory, method)

    def closed(self, method):
        """The motion by the exact solution."""
        trajectory, error, why = self.trajectory(method, self.rtol), math.nan, ""
        for system, stepper, t0, t1, x1 in trajectory.segments:
            given = system, t1 - t0, stepper.start[1], x1
            if type(stepper) is not Exact:
                why = "it becomes a model without one; take method='auto'"
            elif not within(*given, self.rtol):
                error = estimated_error(*given)
                why = (
                    f"it is not accurate here: its error is about {error:.1g}, and rtol = "
                    f"{self.rtol:g} was asked for; take another method, or a larger rtol"
                )
            if why:
                break
        else:
            return self.motion(trajectory, method, trajectory.exact_error)
        words = f"the closed form of {self.system.model.name!r} does not do: {why}"
        if math.isnan(error):
            raise ModelError(words)
        raise AccuracyError(words, self.motion(trajectory, method, error))

    def calibrated(self, method, heyoka=False):
        """The motion by two runs or more, see :mod:`newton_euler.motion.methods.table`; with
        ``heyoka`` by heyoka if the first run shows that the second would take long.
        """
        begun, least, scaled = perf_counter(), method.min_tolerance, method.name == "taylor"
        tolerance = max(min(self.rtol / method.tolerance_ratio, method.max_tolerance), least)
        coarse = method.other(tolerance)
        samples = SIZE_SAMPLES if scaled else None
        before = self.compared(method, coarse, tolerance, None, scaled, samples)
        if isinstance(before.failed, LengthError):
            return self.motion(before, method, math.nan)
        known = None if before.failed else before.sizes()
        # of order 8: the number of steps grows as tolerance**(-1/8)
        if heyoka and (perf_counter() - begun) * (coarse / tolerance) ** 0.125 > HEYOKA_BREAK_EVEN:
            with suppress(MotionError):
                return self.by(METHODS["taylor"])
        for _ in range(MAX_REFINEMENTS):
            trajectory = self.trajectory(method, tolerance, known, scaled)
            error = predicted_error(before, trajectory, method)
            if error <= self.rtol or trajectory.failed:
                break
            finer = max(tolerance * min(max(self.rtol / 2 / error, 1e-3), 0.1), least)
            if finer > tolerance / 2:
                # as fine as it gets: a run that is closer to it may tell more
                before = self.compared(method, 10 * tolerance, tolerance, known, scaled)
                error = min(error, predicted_error(before, trajectory, method))
                break
            before, tolerance = trajectory, finer
            if not method.adaptive:  # it starts beside the start, as the first did
                before = self.compared(method, method.other(finer), finer, known, scaled)
        self.system.traced.seconds += perf_counter() - begun
        motion = self.motion(trajectory, method, told(error, self.rtol))
        if not error <= self.rtol:
            raise AccuracyError(self.too_inaccurate(motion), motion)
        return motion

    def too_inaccurate(self, motion):
        """What is said of a motion whose error is above the rtol."""
        error, model = motion.error, self.system.model
        if error < 0.05:
            had = f"about {error:.1g}"
            could = f"ask for rtol = {10.0 ** math.ceil(math.log10(error)):.0g}"
        else:  # it may be infinite, or nan
            had = "large: no digit is certain"
            could = "the motion forgets its start; take a shorter time"
        return (
            f"{model.name}, at t = {motion.t_end:.6g}: the error by method {motion.method.name!r} "
            f"is {had}, and rtol = {self.rtol:g} was asked for; {could}. The motion with this "
            "error is .reached of this exception"
        )


def told(error, rtol):
    """The error that is told: with some more safety than that which is compared with the rtol, but
    not above it.
    """
    return max(error, min(rtol, TOLD_SAFETY * error))


def predicted_error(before, trajectory, method):
    """The error of a trajectory, predicted from its difference to one of coarser tolerance."""
    difference, tolerance = before.difference(trajectory), trajectory.tolerance
    ratio, traced = tolerance / before.tolerance, trajectory.segments[0].system.traced
    coarse, fine = (
        sum([len(part.stepper.step_times) - 1 for part in t.segments]) for t in (before, trajectory)
    )
    # a fixed step follows from the tolerance, and heyoka's order, not its steps
    regular = method.name == "taylor" or coarse >= MIN_STEPS
    if method.adaptive:
        off = fine / max(coarse, 1) * ratio ** (1 / method.order)
        regular = regular and 1 / STEPS_OFF < off < STEPS_OFF
    if traced.kinks or traced.hazards:
        regular = False
    system, stepper, t0, t1, x1 = trajectory.segments[-1]
    more = time_round_off(system, t1, x1, stepper.scales, t1 - t0 or 1.0)
    if method.name == "taylor" and traced.hazards:
        more += RESIDUAL_SAFETY * max([part.stepper.residual() for part in trajectory.segments])
    return predicted(difference, ratio, tolerance, regular, fine) + more


def predicted(difference, ratio, tolerance, regular=True, steps=0):
    """The error of a run, predicted from its difference to one of another tolerance.

    ratio : of its tolerance to the other
    """
    if not difference <= 0.05:
        return difference  # the other one is too far off to predict anything
    growth = math.sqrt(1 + steps / 100)
    if ratio > 1:  # the other one is more accurate: this is the error itself
        return SERIES_SAFETY * difference + SERIES_ROUND_OFF * growth
    error = SAFETY * difference * ratio ** (REGULAR if regular else IRREGULAR)
    return max(error, tolerance) + ROUND_OFF * growth


def verified_series(system, rtol, method):
    """For runs of heyoka from t = 0: a function ``(t, start, x)`` that is true if the end ``x`` was
    compared with that of another run, or one close to it was, and is as accurate as asked.
    """
    tolerance = level_of(rtol / method.tolerance_ratio)

    def verify(t, start, x):
        if knots(system, 0.0, t):
            return False  # this run did not stop there
        if system.verified.covers(rtol, 0.0, t, start, x):
            return True
        run = Run(system, 0.0, t, start, rtol)
        other = run.compared(method, method.other(tolerance), tolerance, None, False, SIZE_SAMPLES)
        if other.failed:
            return False
        _, stepper, _, _, end = other.segments[-1]
        rows = zip(x, end, stepper.scales, strict=True)
        difference = max(abs(u - v) / (s or 1.0) for u, v, s in rows)
        error = predicted(difference, tolerance / other.tolerance, tolerance)
        error += time_round_off(system, t, x, stepper.scales, t)
        if error <= rtol:
            system.verified.add(rtol, 0.0, t, start, x, error)
        return error <= rtol

    return verify
