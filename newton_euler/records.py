"""What an integration returns: the states of a motion, and what is known about them."""

import math
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import NamedTuple

from .courses import sample_times
from .models import ModelError

DEFAULT_SAMPLES = 101  # samples of a motion without steps


class MotionError(ModelError):
    """A motion that could not be followed to its end; ``reached`` is the :class:`Motion` up to there."""

    def __init__(self, message, reached):
        super().__init__(message)
        self.reached = reached


class Cost(NamedTuple):
    """``seconds`` of integrating, all runs, with imports and compilations they need; ``preparing`` the model; ``calls`` of the right-hand side."""

    seconds: float
    preparing: float
    calls: int


@dataclass(frozen=True, eq=False)
class Motion:
    """The motion of a model.

    model, method, rtol : what was asked for, the method being the one that was taken
    legs : the parts between events at which it became another; ``events`` : what happened, each with ``name``, ``t`` and ``state``
    ended : in words; ``cost`` : a :class:`Cost`
    times, states : of the samples; ``states["theta"]`` is an array; nan where a leg has no such state
    error : the estimated error at the end, of the worst state relative to its largest size (at least 1e-6 in its unit)
    drift : by the name of each invariant its largest change over the samples, relative to its largest size

    >>> from newton_euler import Model
    >>> fall = Model("fall", {"g": 10.0}, ("h", "v"), lambda s, p, t: (s.v, -p.g), exact=lambda s, p, t: (s.h + s.v*t - p.g*t*t/2, s.v - p.g*t))
    >>> from newton_euler.motion import integrate
    >>> motion = integrate(fall, 2.0, (100.0, 0.0), samples=3)
    >>> motion.states["h"].tolist(), motion.end["v"], motion.method.name
    ([100.0, 95.0, 80.0], -20.0, 'exact')
    """

    model: object
    segments: tuple
    events: tuple
    method: object
    rtol: float
    ended: str
    cost: Cost
    samples: object = field(default=None, repr=False)
    estimate: object = field(default=math.nan, repr=False)

    @property
    def t_end(self):
        """The time at which it ended."""
        return self.segments[-1].t1

    @cached_property
    def end(self):
        """The last state, by name."""
        segment = self.segments[-1]
        return dict(zip(segment.system.model.states, segment.x1, strict=True))

    @cached_property
    def error(self):
        """See the class; for heyoka it takes a second run with shorter steps, made when it is first asked for."""
        return self.estimate() if callable(self.estimate) else self.estimate

    @cached_property
    def times(self):
        """The instants of the samples, an array."""
        import numpy as np

        begin, end, samples = self.segments[0].t0, self.t_end, self.samples
        if samples is None:
            ends = [b for segment in self.segments for b in segment.stepper.step_times[1:] if b < segment.t1] + [
                segment.t1 for segment in self.segments
            ]
            return np.array([begin, *sorted(ends)]) if len(ends) > len(self.segments) else np.linspace(begin, end, DEFAULT_SAMPLES)
        return sample_times(samples, begin, end)

    @cached_property
    def states(self):
        """The states at ``times``, arrays by name."""
        return MappingProxyType(self._at(self.times))

    def at(self, t):
        """The states at any time of the motion, by name: numbers, or arrays for an array of times. Raises :class:`ModelError` outside.

        As accurate as the steps, or for the Runge-Kutta methods up to ten times less: their interpolation has one order less.
        """
        import numpy as np

        times = np.atleast_1d(np.asarray(t, dtype=float))
        begin, end = self.segments[0].t0, self.t_end
        if not np.all((times >= begin) & (times <= end)):
            raise ModelError(f"the motion goes from t = {begin:g} to {end:g}; it says nothing about t = {t!r}")
        found = self._at(times)
        return found if np.ndim(t) else {n: float(x[0]) for n, x in found.items()}

    def _at(self, times):
        import numpy as np

        if len(self.segments) == 1:
            rows = self.segments[0].stepper.states(times)
            rows[:, times == self.t_end] = np.array(self.segments[0].x1)[:, None]
            return dict(zip(self.model.states, rows, strict=True))
        names = dict.fromkeys(n for segment in self.segments for n in segment.system.model.states)
        out = {n: np.full(len(times), math.nan) for n in names}
        starts = [segment.t0 for segment in self.segments]
        which = np.maximum(np.searchsorted(starts, times, side="right") - 1, 0)
        for n in np.unique(which):
            segment, chosen = self.segments[n], which == n
            for name, row in zip(segment.system.model.states, segment.stepper.states(times[chosen]), strict=True):
                out[name][chosen] = row
        last = (times == self.t_end) & (which == len(self.segments) - 1)
        for name, x in self.end.items():
            out[name][last] = x
        return out

    @cached_property
    def drift(self):
        """See the class; within each leg, of which the worst counts."""
        worst = {}
        for segment in self.segments:
            for name, values in self._invariants(segment).items():
                size = abs(values).max()
                change = abs(values - values[0]).max()
                worst[name] = max(worst.get(name, 0.0), float(change / size) if size else 0.0)
        return worst

    def _invariants(self, segment):
        import numpy as np

        if not segment.system.model.invariants:
            return {}
        times = self.times[(self.times >= segment.t0) & (self.times <= segment.t1)]
        times = np.unique([segment.t0, *times])
        x = segment.stepper.states(times)
        functions = segment.system.model.invariants.items()
        return {name: np.broadcast_to(segment.system.function(f)(times, *x), times.shape) for name, f in functions}

    def explain(self):
        """All of it in words, one fact a line."""
        lines = [f"{self.model.name}, from t = {self.segments[0].t0:g} to {self.t_end:.9g}: {self.ended}"]
        lines.append(f"method: {self.method.name} ({self.method.description})")
        kept = "" if not self.error > self.rtol else ", not reached" if self.error == self.error else ""
        lines.append(f"error of the last state: about {self.error:.1g}, asked for {self.rtol:.1g}{kept}")
        lines += [f"drift of {name}: {value:.1g}" for name, value in self.drift.items()]
        lines += [f"{event.name} at t = {event.t:.9g}" for event in self.events[:10]]
        if len(self.events) > 10:
            lines.append(f"... and {len(self.events) - 10} more events")
        seconds, calls = self.cost.seconds, self.cost.calls
        lines.append(f"cost: {1e3 * seconds:.3g} ms, {calls} calls of the right-hand side, {1e3 * self.cost.preparing:.3g} ms to prepare")
        return "\n".join(lines)

    __str__ = explain
