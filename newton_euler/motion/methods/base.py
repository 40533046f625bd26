"""The base class of the methods of integration: a stepper advances one state step by step, and
interpolates between its steps. The table of all methods: :mod:`.table`.
"""

from bisect import bisect_right
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from math import inf, ulp
from typing import Any, Protocol, TypeAlias

from ...algebra.compile import Compiled
from ...algebra.errors import NewtonEulerError
from ...algebra.late import np
from ...algebra.scalars import Scalar
from ...algebra.trace import Step

# the scale of a state that is zero, where nothing else is known about it
SMALLEST_SCALE = 1e-6
# a run has stalled if this many steps are on average this much shorter than its longest step
MAX_STALLED_STEPS, STALLED_RATIO = 2000, 1e-5
MAX_STEPS = 5e6  # steps of one motion that are kept: those of DOP853 take minutes and a gigabyte


Floats: TypeAlias = tuple[float, ...]
FastRun: TypeAlias = Callable[[float, Floats], Floats | None]  # takes the time and the start


class TracedRates(Protocol):
    """What is asked of a :class:`~newton_euler.motion.prepared.Traced` by those below it."""

    rhs: Compiled
    arguments: int
    integrators: dict

    @property
    def folded(self) -> tuple[Compiled, Compiled]: ...

    depends: dict[int, set[str]]
    choices: list[tuple[Scalar, Scalar]]
    compiled_choices: Callable[..., Floats]
    clocked: list[Step]
    kinks: list[str]
    inner: list[str]
    hazards: list[str]
    surprises: bool
    narrow: Any  # Arguments, of a file above


class System(Protocol):
    """What is asked of a :class:`~newton_euler.motion.prepared.PreparedModel` by those below it."""

    model: Any  # a Model, of a file above
    p: tuple
    f: Callable[..., Floats]

    @property
    def traced(self) -> TracedRates: ...
    @property
    def autonomous(self) -> bool: ...
    @property
    def constants(self) -> Floats: ...
    @property
    def folded_rates(self) -> Callable[..., Floats]: ...
    @property
    def exact_on_floats(self) -> Callable[..., Floats] | None: ...
    @property
    def solution(self) -> Callable[[float, Floats], Floats]: ...
    def solutions(self, times: "np.ndarray", x: Floats) -> "np.ndarray": ...
    def rates(self, t: float, x: Floats) -> Floats: ...
    def function(self, f: Callable[..., Any]) -> Callable[..., Any]: ...
    def narrow_of(self, f: Callable[..., Any]) -> Any: ...


class Demand(Protocol):
    """What a stepper asks of its :class:`~newton_euler.motion.trajectory.Trajectory`."""

    goal: float
    tolerance: float
    step: float | None
    max_steps: float
    longest_part: float
    samples: Any
    units: Sequence[float]
    method: Any  # a Method, whose table knows the steppers

    def limits(self, system: System, t: float, x: Floats) -> tuple[Floats, Floats, Floats]: ...


def sample_times(samples: Any, begin: float, end: float) -> "np.ndarray":
    """An array: the times of ``samples`` between begin and end, or this many equally spaced."""
    if isinstance(samples, int):
        return np.linspace(begin, end, samples)
    times = np.asarray(samples, dtype=float)
    inside = (times >= begin) & (times <= end)
    return times.copy() if inside.all() else times[inside]


def rows_of(values: Sequence[Any], count: int) -> "np.ndarray":
    """An array (rows, count) of these rows; one of them may be a number."""
    out = np.empty((len(values), count))
    for n, row in enumerate(values):
        out[n] = row
    return out


class StepError(NewtonEulerError, ArithmeticError):
    """Raised where a method cannot continue from the state that it has reached."""


class LengthError(StepError):
    """Raised where a method would need more steps than are feasible."""


class Stepper:
    """One run of a method from the state ``x`` at ``t`` to the ``goal`` of a trajectory, which has
    the ``tolerance``, the fixed ``step`` or None, and the ``samples``.

    t, x : the time and the state reached so far; ``start`` : the first ones, as a pair
    step_times : the times between steps; ``calls`` : evaluations of the right-hand side
    scales : of the error of each state: its largest absolute value so far, but not less than its
        ``floors``; ``noise`` : the round-off in each state
    stops : times after the start, up to the goal, that no step may pass over
    near : see :func:`~newton_euler.motion.narrow.passage`
    steps : for each step a tuple whose last elements are the state before it; or empty, if not kept
    most_steps : the most steps of one motion

    around : units in the last place about a stop, whose time is rounded, in which no step is taken
    resumable : True if the method can go back to one of its steps
    repeated : True if it has gone back
    taken : the number of steps, for a method that does not keep all of them
    halved : a function of a step's number: its difference from two halves, over the scales; or None
    remade : names of attributes that no pickle contains, since they are functions; those that a
        state between two steps needs are cached properties

    A subclass defines ``begin``, ``step`` and ``interpolate``; one that is resumable, ``resume``.
    """

    most_steps = MAX_STEPS
    around = 8
    resumable, repeated, taken = False, False, 0
    halved: Callable | None = None
    remade: tuple[str, ...] = ()

    def __init__(self, system: System, t: float, x: Floats, trajectory: Demand):
        self.system, self.t, self.x, self.goal = system, t, tuple(x), trajectory.goal
        self.tolerance, self.start = trajectory.tolerance, (t, self.x)
        self.max_steps = min(trajectory.max_steps, self.most_steps)
        self.step_times, self.calls, self.checked, self.longest = [t], 0, 0, 0.0
        self.steps: list[tuple] = []
        self.near: list[tuple[float, int]] = []
        self.floors, self.noise, self.stops = trajectory.limits(system, t, self.x)
        self.scales = tuple(map(max, map(abs, x), self.floors))
        self.begin(trajectory)

    def __getstate__(self):
        return {n: x for n, x in vars(self).items() if n not in self.remade}

    def begin(self, trajectory: Demand) -> None:
        """Prepare the run; called once."""

    def step(self, limit: float = inf) -> None:
        """Take at most this many steps."""

    def interpolate(self, n: int, times: "np.ndarray") -> "np.ndarray":
        """The states at an array of times inside step n, an array (states, times)."""
        raise NotImplementedError

    def resume(self) -> None:
        """Continue from the present state, see :meth:`back_to`."""

    @staticmethod
    def fast_run(system: System, tolerance: float) -> FastRun | None:
        """A function ``(t, start)`` that returns the state at ``t`` after ``start`` at t = 0 as
        fast as possible, without a record and without an error, or None where it does not get
        there; None for a method that has no such run.
        """
        return None

    def residual(self) -> float:
        """What the rates of a series leave of those of the model; 0 for other methods."""
        return 0.0

    @property
    def dense(self) -> "Stepper":
        """The same run with all of its steps."""
        return self

    def back_to(self, n: int, stops: Iterable[float], scales: Floats | None = None) -> None:
        """Go back to the beginning of step ``n``, with these scales, and stop at these times."""
        size = len(self.x)
        self.t, self.x, self.repeated = self.step_times[n], tuple(self.steps[n][-size:]), True
        seen = () if scales else [map(abs, s[-size:]) for s in self.steps[: n + 1]]
        self.scales = scales or tuple(map(max, self.floors, *seen))
        del self.steps[n:], self.step_times[n + 1 :]
        self.checked = min(self.checked, n)
        self.stops = tuple(sorted({t for t in (*stops, *self.stops) if t > self.t}))
        self.resume()

    def next_stop(self) -> float:
        """The time at which the next step must end at the latest."""
        n = bisect_right(self.stops, self.t)
        return self.stops[n] if n < len(self.stops) else self.goal

    def around_stop(self) -> tuple[float, float]:
        """The same as a pair: a time just before it, up to which to go, and one just after it, from
        which to continue, since the rates may jump there; without a stop, the goal twice.
        """
        n = bisect_right(self.stops, self.t)
        if n == len(self.stops):
            return self.goal, self.goal
        stop, room = self.stops[n], self.around * ulp(self.stops[n])
        return max(stop - room, self.t), min(stop + room, self.goal)

    def pass_stop(self, after: float, part: float = 0.5) -> None:
        """Go past a stop: ``part`` of the way by the rates before it, the rest by those after."""
        step, before = after - self.t, self.system.rates(self.t, self.x)

        def moved(rates):
            return tuple([v + step * k for v, k in zip(self.x, rates, strict=True)])

        later = self.system.rates(after, moved(before))
        mean = [part * k + (1 - part) * m for k, m in zip(before, later, strict=True)]
        self.t, self.x = after, moved(mean)

    @property
    def checkpoints(self) -> list[tuple[float, Floats]]:
        """Two pairs (time, state) from the second half of the steps, at which two runs are
        compared; empty if there are few. Where steps were repeated, from the second half of the
        time: most are within something narrow, in which the states of two runs differ for a moment.
        """
        count, size, times = len(self.steps), len(self.x), self.step_times
        chosen = [3 * count // 5, 4 * count // 5] if count > 4 else []
        if self.repeated and chosen:
            late = (times[0] + part * (self.t - times[0]) for part in (0.6, 0.8))
            chosen = [max(bisect_right(times, t) - 1, 1) for t in late]
        return [(self.step_times[n], self.steps[n][-size:]) for n in chosen]

    def step_index(self, t: float) -> int:
        """The index of the step in which ``t`` lies."""
        return min(max(bisect_right(self.step_times, t) - 1, 0), len(self.step_times) - 2)

    def step_end(self, n: int) -> float:
        """The time up to which step n was taken by the method: not past a stop."""
        return self.step_times[n + 1]

    def state_at(self, t: float) -> Floats:
        """The state at a time that has been passed, as accurate as the steps are."""
        return tuple(self.interpolate(self.step_index(t), np.array([t]))[:, 0].tolist())

    def states(self, times: Any) -> "np.ndarray":
        """The states at an array of times that have been passed, an array (states, times)."""
        times = np.asarray(times, dtype=float)
        out = np.repeat(np.array(self.x)[:, None], len(times), axis=1)
        index = np.maximum(np.searchsorted(self.step_times[:-1], times, side="right") - 1, 0)
        for n in np.unique(index) if len(self.step_times) > 1 else ():
            inside = index == n
            out[:, inside] = self.interpolate(int(n), times[inside])
        return out

    def check_progress(self) -> None:
        """Raise :class:`StepError` if the last steps have stalled, as at a pole."""
        count = len(self.step_times) - 1 - self.checked
        if count >= MAX_STALLED_STEPS:
            last = self.step_times[self.checked :]
            self.longest = max(self.longest, *(b - a for a, b in pairwise(last)))
            if self.t - last[0] < STALLED_RATIO * count * self.longest:
                raise StepError(f"{count} steps took only {self.t - last[0]:.1g} of time")
            self.checked += count
            self.check_length(self.checked)

    def check_length(self, count: int) -> None:
        """Raise :class:`LengthError` if, by the ``count`` so far, too many steps are needed."""
        (begin, _), most = self.start, self.max_steps
        passed, whole = self.t - begin, self.goal - begin
        if passed > 0 and count * whole > most * passed:
            raise LengthError(
                f"about {count * (whole / passed):.1g} steps would be needed to reach t = "
                f"{self.goal:.6g}; {most:.0g} are possible, which is up to about t = "
                f"{begin + most / count * passed:.1g}: take a shorter time"
            )

    def update_scales(self) -> None:
        """Update the scales with the present state."""
        self.scales = tuple(map(max, self.scales, map(abs, self.x)))
