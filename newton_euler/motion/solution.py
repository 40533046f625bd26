"""The result of an integration: the states of a motion, their error, drift, and cost."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple

from ..algebra.late import np
from ..algebra.names import Guided, guided
from ..algebra.scalars import Scalar
from .events import Occurrence
from .methods.base import sample_times
from .methods.table import Method
from .model import Model, ModelError, real_numbers

DEFAULT_SAMPLES = 101  # number of times for a motion without steps


class UnfitError(ModelError):
    """Raised for a method that cannot integrate this model: take another one, or "auto"."""


class MotionError(ModelError):
    """Raised where a motion could not be followed to its end; ``reached`` is the :class:`Motion` up
    to there. Subclasses name what can be done; else the coordinates may be singular: take others.
    """

    reached: Any  # a Motion; of an AccuracyError perhaps Motions, of a file above

    def __init__(self, message: str, reached: Guided):
        super().__init__(message)
        self.reached = reached

    def __reduce__(self):
        return type(self), (str(self), self.reached)


class StickingError(MotionError):
    """Raised where the rates on both sides of a place lead back to it, as of dry friction at rest:
    write an :class:`~.events.Event`, whose ``then`` continues with a model of what sticks.
    """


class NoValueError(MotionError):
    """Raised where the rates have no value beyond, as a root of a negative number or a table at its
    end: end the motion there by an :class:`~newton_euler.motion.events.Event`, or change the model.
    """


class LongError(MotionError):
    """Raised where more steps would be needed than are feasible: take a shorter time."""


class AccuracyError(MotionError):
    """Raised where the requested tolerance cannot be reached; ``reached`` is the :class:`Motion`,
    or the :class:`~newton_euler.motion.batch.Motions`, with its error.
    """


class FarError(AccuracyError):
    """Raised where the round-off of a large state is too much for one that is small beside it, as
    the speed on a spring far from the origin; ``reached`` is as accurate as requested relative to
    the sizes that follow from the couplings of the states, see :mod:`newton_euler.motion.sizes`.
    """


class Cost(NamedTuple):
    """``seconds`` with imports and compilations, those of ``preparing``; ``calls`` of the rates."""

    seconds: float
    preparing: float
    calls: int


@dataclass(frozen=True, eq=False)
class Motion(Guided):
    """The motion of a model.

    model, rtol : as requested; ``method`` : the one that was used
    segments : the parts between events at which the state jumped or the model changed
    events : the :class:`~newton_euler.motion.events.Occurrence` of each event that occurred
    ended : how it ended, in words; ``cost`` : a :class:`Cost`
    times, states : those of the samples; ``states["theta"]`` is an array, nan where there is none
    error : the estimated error at the end, of the worst state relative to its largest value, see
        ``rtol`` of :func:`~newton_euler.motion.integration.integrate`; nan with a fixed step
    drift : for each invariant, by name, its largest change over the samples, relative to its
        largest value

    >>> from newton_euler import Model, integrate
    >>> fall = Model("fall", {"g": 10.0}, ("h", "v"), lambda s, p, t: (s.v, -p.g))
    >>> motion = integrate(fall, 2.0, (100.0, 0.0), method="dop853", samples=3)
    >>> motion.states["h"].round(6).tolist(), round(motion.end["v"], 6), motion.method.name
    ([100.0, 95.0, 80.0], -20.0, 'dop853')
    """

    model: Model
    segments: tuple
    events: tuple[Occurrence, ...]
    method: Method
    rtol: float
    ended: str
    cost: Cost
    samples: Any = field(default=None, repr=False)
    estimate: float | Callable[[], float] = field(default=math.nan, repr=False)

    def __getstate__(self):
        """With all that is computed on demand: elsewhere it might differ, as without heyoka."""
        known = {n: getattr(self, n) for n in ("times", "states", "end", "error", "drift")}
        return {**vars(self), **known, "estimate": known["error"]}

    @property
    def t_end(self) -> float:
        """The time at which the motion ended."""
        return self.segments[-1].t1

    @cached_property
    def end(self) -> dict[str, float]:
        """The last state, by name."""
        last = self.segments[-1]
        return last.system.model._state(last.x1)

    @cached_property
    def error(self) -> float:
        """The estimated error at the end, see the class; made when first read if it takes long."""
        return self.estimate() if callable(self.estimate) else self.estimate

    @cached_property
    def times(self) -> Scalar:
        """The times of the samples, an array."""
        begin, end, segments = self.segments[0].t0, self.t_end, self.segments
        if self.samples is not None:
            return sample_times(self.samples, begin, end)
        steps = [t for part in segments for t in part.stepper.step_times[1:] if t < part.t1]
        if not steps:
            return np.linspace(begin, end, DEFAULT_SAMPLES)
        return np.array([begin, *sorted([*steps, *(part.t1 for part in segments)])])

    @cached_property
    def states(self) -> Mapping[str, Scalar]:
        """The states at ``times``, arrays by name."""
        return MappingProxyType(self._at(self.times))

    def at(self, t: Scalar) -> dict[str, Scalar]:
        """The states at any time of the motion, by name: numbers, or arrays for an array of times.

        As accurate as the steps, or up to ten times less for the Runge-Kutta methods, whose
        interpolation has one order less. Raises :class:`ModelError` outside the motion.
        """
        begin, end = self.segments[0].t0, self.t_end
        if type(t) in (float, int):
            inside = begin <= t <= end
        else:
            what = "at() takes a time of the motion, or an array of times"
            t = real_numbers(t, what)
            if t.ndim > 1:
                raise ModelError(f"{what} of one axis; got an array of shape {t.shape}")
            inside = ((begin <= t) & (t <= end)).all()
        if not inside:
            raise ModelError(f"the motion goes from t = {begin:g} to {end:g}; got t = {t!r}")
        if getattr(t, "ndim", 0):
            return self._at(t)
        t, found = float(t), dict.fromkeys(self._names, math.nan)
        if t == self.t_end:
            return found | self.end
        part = [part for part in self.segments if part.t0 <= t][-1]
        return found | dict(zip(part.system.model.states, part.stepper.state_at(t), strict=True))

    @property
    def _names(self):
        """Those of the states of all segments, as the keys of a dict."""
        return dict.fromkeys(n for part in self.segments for n in part.system.model.states)

    def _at(self, times):
        first, *more = self.segments
        if more:
            out = {n: np.full(len(times), math.nan) for n in self._names}
            begins = [part.t0 for part in self.segments]
            index = np.maximum(np.searchsorted(begins, times, side="right") - 1, 0)
            for n in np.unique(index):
                part, inside = self.segments[n], index == n
                rows = part.stepper.states(times[inside])
                for name, row in zip(part.system.model.states, rows, strict=True):
                    out[name][inside] = row
        else:
            out = dict(zip(self._names, first.stepper.states(times), strict=True))
        # the stepper interpolates: the last state would differ by round-off
        at_end = times == self.t_end
        for name, x in self.end.items():
            out[name][at_end] = x
        return out

    @cached_property
    @guided
    def drift(self) -> dict[str, float]:
        """The drift of each invariant by name, see the class; of segments the worst."""
        worst: dict[str, float] = {}
        for system, stepper, t0, t1, _ in self.segments:
            times = np.unique([t0, *self.times[(self.times >= t0) & (self.times <= t1)]])
            x = stepper.states(times) if system.model.invariants else ()
            for name, f in system.model.invariants.items():
                values = system.values(f, times, x)
                largest = abs(values).max()
                change = float(abs(values - values[0]).max() / largest) if largest else 0.0
                worst[name] = max(worst.get(name, 0.0), change)
        return worst

    def explain(self) -> str:
        """A summary of the motion as text, one fact a line."""
        missed = ", not reached" if self.error > self.rtol else ""
        seconds, preparing, calls = self.cost
        more = len(self.events) - 10
        return "\n".join(
            [
                f"{self.model.name}, from t = {self.segments[0].t0:g} to {self.t_end:.9g}: "
                f"{self.ended}",
                f"method: {self.method.name} ({self.method.description})",
                f"error of the last state: about {self.error:.1g}, asked for {self.rtol:.1g}"
                + missed,
                *(f"drift of {name}: {value:.1g}" for name, value in self.drift.items()),
                *(f"{event.name} at t = {event.t:.9g}" for event in self.events[:10]),
                *([f"... and {more} more events"] if more > 0 else []),
                f"cost: {1e3 * seconds:.3g} ms, {calls} calls of the right-hand side, "
                f"{1e3 * preparing:.3g} ms to prepare",
            ]
        )

    __str__ = explain
