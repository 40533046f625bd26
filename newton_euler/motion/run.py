"""One integration of one motion: the method, its tolerance, its error against the rtol."""

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from time import perf_counter
from typing import Any

from . import sizes, solution
from .drives import driven
from .error_estimates import ROUND_OFF_OF_RATES, error_by_comparison, relative_shift, reported_error
from .events import EventError
from .knots import knots
from .methods.base import LengthError
from .methods.exact import estimated_error, within
from .methods.table import METHODS, Method
from .model import ModelError
from .prepared import PreparedModel
from .sizes import NATURAL_PART, Sizes, are_settled, forced_error, small, worst_ratio
from .solution import AccuracyError, Cost, FarError, Motion, MotionError
from .trajectory import Trajectory

# seconds of integrating one right-hand side after which compiling with heyoka would have paid off
HEYOKA_BREAK_EVEN = 0.5
FEW_STEPS = 1e5  # the most steps tried where the closed form is not accurate enough
MANY_STEPS = 2e4  # the most steps of a long motion, in which the errors of steps add up
# instants at which a series samples the sizes of the states: by a prime number of intervals, since
# at the 32nd parts of 10 000 periods a speed may be zero each time
SIZE_SAMPLES = 38
FAR_LARGER = 1e6  # a state this many times its first size: the first run missed something
MAX_REFINEMENTS = 5  # the most tolerances tried
UNLUCKY = 10.0  # a run across kinks may be off by this many times its estimate


def usable(name: str, system: PreparedModel, t0: float = 0.0) -> Method:
    """The method of this name; :class:`UnfitError` if it does not suit this model and start."""
    why = METHODS[name].unusable_because(system, t0)
    if why:
        raise solution.UnfitError(f"method {name!r} cannot be used: {why}")
    return METHODS[name]


def known_accurate(
    system: PreparedModel, method: Method, rtol: float, t0: float, t1: float, start: tuple, x: tuple
) -> bool:
    """True if the state ``x`` at t1, by this method from ``start`` at t0, is known to be accurate:
    a closed form by its estimated rounding, a series if this run, or one close to it, was compared.
    """
    if method.closed:
        return within(system, t1 - t0, start, rtol)
    return method.series and system.verified.covers(rtol, t0, t1, start, x)


def outgrown(known: tuple, trajectory: Trajectory) -> bool:
    """True if a state of the trajectory is far larger than its sizes ``known`` say."""
    stepper = trajectory.segments[0].stepper
    rows = zip(stepper.scales, stepper.floors, known[0], strict=True)
    return any(s > FAR_LARGER * max(floor, size) for s, floor, size in rows)


def fast_run(system: PreparedModel, method: Method, rtol: float) -> Callable | None:
    """As :meth:`.Stepper.fast_run`, but None for a state that is not known to be accurate."""
    end = method.stepper.fast_run(system, rtol / method.tolerance_ratio)
    if end is None:
        return None

    def run(t, start):
        x = end(t, start)
        # a series does not stop at knots here
        if x is None or (method.series and knots(system, 0.0, t)):
            return None
        return x if known_accurate(system, method, rtol, 0.0, t, tuple(start), x) else None

    return run


@dataclass(eq=False)
class Run:
    """The arguments of one integration; :meth:`by_name` returns the motion."""

    system: PreparedModel
    t0: float
    t1: float
    state: tuple
    rtol: float
    events: tuple = ()
    samples: Any = None
    progress: Callable | None = None
    step: float | None = None
    preparing: float = 0.0
    max_steps: float = math.inf
    long: bool = False  # see :meth:`briefly`
    own: bool = True  # False: states that are small by cancellation count by their natural sizes
    calls: int = 0
    last: int = 0  # calls of the last trajectory
    narrow: bool = False  # True if steps of a trajectory had to be repeated
    started: float = field(default_factory=perf_counter)

    def by_name(self, name: str) -> Motion:
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

    def by(self, method: Method) -> Motion:
        """The motion by one method within rtol."""
        if method.closed:
            return self.closed(method)
        if method.series and not self.system.traced.hazards:
            return self.series(method)
        return self.calibrated(method)

    def auto(self) -> Motion:
        """The motion by the exact solution if there is one, else by the :meth:`candidates`."""
        refused: list[MotionError] = []
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
                pass  # it has no value for this start, or its model changes: try the others
        for method, heyoka in self.candidates():
            try:
                return self.calibrated(method, True) if heyoka else self.by(method)
            except MotionError as error:
                # a series ends where rates are not analytic, which Runge-Kutta methods can pass
                if not method.series and not refused and not isinstance(error, AccuracyError):
                    raise
                refused.append(error)
                if self.long and isinstance(error, AccuracyError):
                    break  # no other method rounds less
        known = [error for error in refused if isinstance(error, AccuracyError)] or refused
        raise min(known, key=lambda error: error.reached.error)

    def candidates(self) -> list[tuple[Method, bool]]:
        """The methods that "auto" tries, each with True if heyoka may take over from it."""
        system, taylor, dop853 = self.system, METHODS["taylor"], METHODS["dop853"]
        missing, tight = taylor.unusable_because(system), self.rtol < dop853.min_rtol
        if tight and missing:
            raise ModelError(
                f"rtol = {self.rtol:g} needs heyoka, without which the least is "
                f"{dop853.min_rtol:g}; {missing}"
            )
        traced = system.traced
        # hazards are left to a method that sees them
        if missing or (traced.hazards and not tight):
            return [(dop853, False)]
        if tight:
            return [(taylor, False)]
        if traced.integrators or traced.seconds > HEYOKA_BREAK_EVEN:
            return [(taylor, False), (dop853, False)]
        return [(dop853, True), (taylor, False)]

    def closed(self, method: Method) -> Motion:
        """The motion by the exact solution."""
        trajectory = self.trajectory(method, self.rtol)
        it = f"the closed form of {self.system.model.name!r}"
        if any(type(part.stepper) is not method.stepper for part in trajectory.segments):
            raise ModelError(f"{it} ends where it becomes a model without one; take method='auto'")
        parts = [(s.system, s.t1 - s.t0, s.stepper.start[1], s.x1) for s in trajectory.segments]
        motion = self.motion(trajectory, method, lambda: max([estimated_error(*p) for p in parts]))
        for system, t, x0, _ in parts:
            if not within(system, t, x0, self.rtol):
                raise AccuracyError(
                    f"{it} is not accurate here: its error is about {motion.error:.1g}, and rtol = "
                    f"{self.rtol:g} was requested; take another method, or a larger rtol",
                    motion,
                )
        return motion

    def series(self, method: Method) -> Motion:
        """The motion by one run of a series on the states as they are, if that is accurate enough,
        which another run shows or has shown for one close to it; else calibrated.
        """
        trajectory = self.briefly(self.trajectory, method, self.rtol / method.tolerance_ratio)
        if self.long:
            trajectory = self.trajectory(method, method.min_tolerance)
        if isinstance(trajectory.failed, LengthError):
            return self.motion(trajectory, method, math.nan)
        if trajectory.failed:
            return self.calibrated(method)

        def error():
            self.progress = None
            return reported_error(self.error_of_series(method, trajectory)[0], self.rtol)

        ends = self.t0, self.t1, self.state, trajectory.segments[-1].x1
        if not self.events and known_accurate(self.system, method, self.rtol, *ends):
            return self.motion(trajectory, method, error)
        self.progress = None
        found, cancels = self.error_of_series(method, trajectory)
        # a state that is small by cancellation may be all error, of which two runs may be alike
        if not found <= self.rtol or cancels:
            return self.calibrated(method)
        if not (self.events or self.long):  # other runs end early, or by a finer series
            self.system.verified.add(self.rtol, *ends, found)
        return self.motion(trajectory, method, reported_error(found, self.rtol))

    def error_of_series(self, method: Method, trajectory: Trajectory) -> tuple[float, bool]:
        """The error of the trajectory of a series; whether a state is small by cancellation."""
        tolerance = trajectory.tolerance
        before = self.compared(method, method.other(tolerance), tolerance)

        def judged(one):
            return self.error(before, one), any(small(*run.sizes()[:2]) for run in (one, before))

        error, cancels = judged(trajectory)
        met = error <= self.rtol and not cancels
        # a state may happen to be nearly zero at both ends
        if met or are_settled(before.largest(), trajectory.largest()):
            return error, cancels
        return judged(self.trajectory(method, tolerance, None, False, SIZE_SAMPLES))

    def calibrated(
        self, method: Method, heyoka: bool = False, known: Sizes | None = None
    ) -> Motion:
        """The motion by two runs or more, see :mod:`newton_euler.motion.methods.table`, from the
        sizes ``known``; with ``heyoka`` by it if the first run shows that it pays off.
        """
        begun, least, scaled = perf_counter(), method.min_tolerance, method.series
        tolerance = max(min(self.rtol / method.tolerance_ratio, method.max_tolerance), least)
        narrow = self.narrow
        if method.series and self.long:
            tolerance = least
        coarse = method.other(tolerance)
        comparison, sure = (method, coarse, tolerance, known, scaled), known
        run = self.briefly if heyoka else lambda f, *arguments: f(*arguments)
        before = run(self.compared, *comparison)
        if heyoka and self.long:
            try:
                return self.by(METHODS["taylor"])
            except AccuracyError:
                raise
            except MotionError:  # a series may end where this method does not
                before = self.compared(*comparison)
        if isinstance(before.failed, LengthError):
            return self.motion(before, method, math.nan)
        first, (before, known) = before, self.resolved(before, method, coarse, tolerance, scaled)
        # the method has order 8: the number of steps grows as tolerance**(-1/8)
        if heyoka and (perf_counter() - begun) * (coarse / tolerance) ** 0.125 > HEYOKA_BREAK_EVEN:
            with suppress(MotionError):
                return self.by(METHODS["taylor"])
        for _ in range(MAX_REFINEMENTS):
            trajectory = self.trajectory(method, tolerance, known, scaled)
            if not sure and before is first and known and not trajectory.failed:
                # the first run may have been far off, and have made a state large
                shrunk = not are_settled(known[0], trajectory.largest())
                sure = self.sizes(trajectory) if shrunk else known
                if not are_settled(known[0], sure[0]):
                    return self.calibrated(method, known=sure)
            if trajectory.repeated and not before.watched:
                before = self.compared(method, before.tolerance, tolerance, known, scaled)
            forced = forced_error(*known[:2], trajectory.calls) if known else 0.0
            error = max(forced, self.error(before, trajectory))
            if error <= self.rtol or self.ended(trajectory):
                break
            if known and not narrow and (trajectory.failed or outgrown(known, trajectory)):
                self.narrow = True  # the first one passed over what made it large, or stopped it
                return self.calibrated(method)
            if trajectory.failed:
                break
            finer = max(tolerance * min(max(self.rtol / 2 / error, 1e-3), 0.1), least)
            if finer > tolerance / 2:
                # the least tolerance: a run closer to it may give a smaller bound, if it sees all
                self.narrow = True
                before = self.compared(method, 10 * tolerance, tolerance, known, scaled)
                error = min(error, max(forced, self.error(before, trajectory)))
                break
            before, tolerance = trajectory, finer
            if not method.adaptive:  # the one before has the same start
                before = self.compared(method, method.other(finer), finer, known, scaled)
        if not error <= self.rtol or trajectory.failed:
            trajectory, error = self.stopping(trajectory, known, max(forced, error), forced)
        self.system.traced.seconds += perf_counter() - begun
        motion = self.motion(trajectory, method, reported_error(error, self.rtol))
        if not error <= self.rtol:
            if known and 10 * forced > min(error, 10 * self.rtol):
                raise self.far_error(method, motion, known)
            raise AccuracyError(self.refusal(motion), motion)
        return motion

    def stopping(
        self, last: Trajectory, known: Sizes | None, error: float, forced: float
    ) -> tuple[Trajectory, float]:
        """The trajectory ``last`` and its error; or those of one whose steps end where the rates
        change their formula, if there are such places, and see less of states from zero, if better.
        """
        method, tolerance, self.narrow = last.method, last.tolerance, True
        # where only the fine one failed, it may have been by the round-off of a state near zero
        other = self.system.traced.choices or (last.failed and known)
        if self.ended(last) or not (method.adaptive and other):
            return last, error
        comparison = method, 10 * tolerance, tolerance
        # the sizes of the first trajectory, which may have missed what made a state large
        known = known if last.failed else self.sizes(last)
        before = self.compared(*comparison, known, stopping=True)
        if known is None and not before.failed:
            known = self.sizes(before)
            before = self.compared(*comparison, known, stopping=True)
        trajectory = self.trajectory(method, tolerance, known, stopping=True)
        found = max(forced, self.error(before, trajectory))
        alike = last.failed or trajectory.difference(last) <= UNLUCKY * error
        better = alike and not trajectory.failed and (last.failed or found < error)
        return (trajectory, found) if better else (last, error)

    @staticmethod
    def ended(trajectory: Trajectory) -> bool:
        """True if what failed is the motion, which sticks or is too long, by whatever steps."""
        of_motions = solution.StickingError, solution.LongError
        return bool(trajectory.failed) and trajectory.refusal in of_motions

    def far_error(self, method: Method, motion: Motion, known: Sizes) -> AccuracyError:
        """The error to be raised where round-off is too much for states that are small."""
        why = self.far_refusal(motion, known)
        try:
            reached = replace(self, own=False).calibrated(method)
        except AccuracyError:
            return AccuracyError(why, motion)
        error = max(motion.error, self.rtol * NATURAL_PART * worst_ratio(*known[:2]))
        return FarError(why, replace(reached, estimate=error))

    def resolved(
        self, before: Trajectory, method: Method, coarse: float, fine: float, scaled: bool
    ) -> tuple[Trajectory, Sizes | None]:
        """The first trajectory and its sizes, None if it failed; where a state is so small that
        these may be those of its error, another one by the sizes that were found.
        """
        known = None
        for _ in range(MAX_REFINEMENTS):
            last, known = known, None if before.failed else self.sizes(before)
            if not known or not (last or small(*known[:2])):
                return before, known
            if last and are_settled(last[0], known[0]):
                break
            before = self.compared(method, coarse, fine, known, scaled)
        again = self.compared(method, fine, fine, known, scaled)
        if known and not again.failed:
            ends = before.segments[-1].x1, again.segments[-1].x1
            apart = tuple([abs(u - v) for u, v in zip(*ends, strict=False)])
            there = partial(driven, before, self.state)
            found = sizes.reproduced(known, again.sizes(), apart, self.rtol, there)
            if found != known[0]:
                known = found, *known[1:]
                before = self.compared(method, coarse, fine, known, scaled)
        return before, known

    def sizes(self, trajectory: Trajectory) -> Sizes:
        """The sizes of a trajectory by which the next ones take their steps."""
        there = partial(driven, trajectory, self.state)
        known = sizes.without_round_off(trajectory.sizes(), there, self.rtol)
        return known if self.own else sizes.as_natural(known)

    def briefly(self, run: Callable[..., Trajectory], *arguments: Any) -> Trajectory:
        """The trajectory ``run(*arguments)``, stopped if it takes many steps: it is ``long``."""
        most, self.max_steps = self.max_steps, min(MANY_STEPS, self.max_steps)
        trajectory = run(*arguments)
        self.max_steps, self.long = most, isinstance(trajectory.failed, LengthError)
        return trajectory

    def trajectory(
        self,
        method: Method,
        tolerance: float,
        known: Sizes | None = None,
        scaled: bool = False,
        samples: int | None = None,
        *,
        stopping: bool = False,
    ) -> Trajectory:
        """The trajectory at one tolerance."""
        more = known, scaled, samples, True, stopping
        trajectory = Trajectory(self, method, tolerance, *more)
        self.last, self.calls = trajectory.calls, self.calls + trajectory.calls
        self.narrow = self.narrow or trajectory.repeated
        return trajectory

    def compared(
        self,
        method: Method,
        tolerance: float,
        fine: float,
        known: Sizes | None = None,
        scaled: bool = False,
        stopping: bool = False,
    ) -> Trajectory:
        """A trajectory to compare with one at the tolerance ``fine``, slightly shifted."""
        # not with events: the start may lie on the surface of one
        shift = 0.0 if self.events else relative_shift(fine / tolerance)
        if known and small(*known[:2]):  # their error is mostly round-off
            shift *= min(sizes.round_off_over(self.last) / ROUND_OFF_OF_RATES, 1.0)
        state = [x * (1 + (-shift if n % 2 else shift)) for n, x in enumerate(self.state)]
        shifted = replace(self, state=tuple(state))
        samples = SIZE_SAMPLES if method.series else None
        more = known, scaled, samples, self.narrow, stopping
        trajectory = Trajectory(shifted, method, tolerance, *more)
        self.last, self.calls = trajectory.calls, self.calls + trajectory.calls
        return trajectory

    @staticmethod
    def error(before: Trajectory, trajectory: Trajectory) -> float:
        """The error of a trajectory by comparison with another one, and by what it has not seen."""
        known = error_by_comparison(before, trajectory, trajectory.method)
        return known + trajectory.unseen(known)

    def motion(self, trajectory: Trajectory, method: Method, error: Any) -> Motion:
        """The motion of a trajectory; raises :class:`MotionError` if that failed."""
        cost = Cost(perf_counter() - self.started, self.preparing, self.calls)
        parts, events = tuple(trajectory.segments), tuple(trajectory.occurrences)
        model, ended = self.system.model, trajectory.ended
        motion = Motion(model, parts, events, method, self.rtol, ended, cost, self.samples, error)
        if trajectory.failed:
            raise trajectory.refusal(f"{ended}; see .reached of this error", motion)
        return motion

    def far_refusal(self, motion: Motion, known: Sizes) -> str:
        """The message for a motion that is too far from the origin for the digits of a float."""
        small_one, large = sizes.far_states(self.system, self.t0, self.state, *known[:2])
        place = f"{self.system.model._state(self.state)[large]:.6g}"
        return (
            f"{self.system.model.name}: {small_one} is small beside the round-off of {large} = "
            f"{place}, which makes an error of about {motion.error:.1g} of its size, and rtol = "
            f"{self.rtol:g} was requested; take the distance from {place} as the state in place of "
            f"{large}"
        )

    def refusal(self, motion: Motion) -> str:
        """The message for a motion whose error is above the rtol."""
        error, model = motion.error, self.system.model
        if error < 0.05:
            reached = f"about {error:.1g}"
            advice = f"ask for rtol = {10.0 ** math.ceil(math.log10(error)):.0g}"
        else:  # it may be infinite, or nan
            reached = "large: no digit is certain"
            advice = "the motion forgets its start; take a shorter time"
        return (
            f"{model.name}, at t = {motion.t_end:.6g}: the error by method {motion.method.name!r} "
            f"is {reached}, and rtol = {self.rtol:g} was requested; {advice}. The motion with this "
            "error is .reached of this exception"
        )
