"""Events: the instants at which a function of the state goes through zero, found on the course of a motion.

On each piece (step) the function is sampled at Chebyshev points. If it is resolved, all roots of its polynomial are at hand, also two of them in one
step, which a comparison of signs at both ends misses; if not, the piece is halved.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

CHEBYSHEV_POINTS = 12
RESOLUTION = 1e-7  # the last coefficients over the largest
MAX_HALVINGS = 8  # halvings


@dataclass(frozen=True)
class Event:
    """Something that happens when ``function(s, p, t)`` goes through zero: impact, loss of contact, end of sliding, a turning point.

    function : of the states, the parameters and the time, as in a :class:`Model`; smooth
    direction : 1 if only where it grows counts, -1 where it falls, 0 both
    terminal : True ends the motion there
    then : a function ``(s, p, t)`` that returns the model and the start with which the motion goes on, ``(model, start)`` or, to change the
        events as well, ``(model, start, events)``; None ends it. If the right-hand side becomes another, this event is no longer looked for.
    name : by which it is listed

    >>> landing = Event(lambda s, p, t: s.h, direction=-1, terminal=True, name="landing")
    """

    function: Callable
    direction: int = 0
    terminal: bool = False
    then: Callable | None = None
    name: str = ""

    @property
    def ends(self):
        """True if the leg of the motion ends with it."""
        return self.terminal or self.then is not None


@dataclass(frozen=True)
class Occurrence:
    """An event that happened: its ``name``, the time ``t``, the ``state`` by name before any switch."""

    name: str
    t: float
    state: dict


class EventLocator:
    """Looks for one event along a course, piece by piece.

    began : True if the leg starts with this very event, whose function is zero there: it is divided by the time since then
    """

    def __init__(self, event, stepper, initial_event):
        self.event, self.stepper, self.initial_event = event, stepper, initial_event
        self.g = stepper.system.function(event.function)
        self.sign = 0 if initial_event else _sign(self.g(stepper.t, *stepper.x))

    def found(self, at):
        """The instants in the piece number ``at``, in order."""
        import numpy as np

        a, b = self.stepper.step_times[at], self.stepper.step_times[at + 1]
        start = self.stepper.start[0]
        nearest = start + max(1e-13 * (b - a), 4e-16 * abs(start))  # so much after the event it is positive or negative

        def g(times):
            times = np.maximum(np.atleast_1d(times), nearest) if self.initial_event else np.atleast_1d(times)
            x = self.stepper.interpolate(at, times)
            try:
                values = np.broadcast_to(np.asarray(self.g(times, *x), dtype=float), times.shape)
            except ValueError:  # it branches on values
                values = np.array([float(self.g(t, *column)) for t, column in zip(times.tolist(), x.T.tolist(), strict=True)])
            return values / (times - start) if self.initial_event else values

        out = []
        for left, right in self._brackets(g, a, b):
            t = self._refined(_root(lambda t: float(g(t)[0]), left, right), g, b - a, at)
            if a <= t <= b * (1 + 1e-15) + 1e-300 and (not self.initial_event or t > self.stepper.start[0]):
                out.append(min(t, b))
        return out

    def _brackets(self, g, a, b, depth=0):
        """Intervals over which the sign changes in the direction asked for."""
        import numpy as np

        nodes, to_coefficients = _chebyshev()
        values = g(a + (b - a) * nodes)
        coefficients = to_coefficients @ values
        largest = np.abs(coefficients).max()
        if depth < MAX_HALVINGS and largest > 0 and np.abs(coefficients[-2:]).max() > RESOLUTION * largest and not _far(coefficients):
            middle = (a + b) / 2
            return self._brackets(g, a, middle, depth + 1) + self._brackets(g, middle, b, depth + 1)
        points = [*(a + (b - a) * x for x in _between(coefficients)), b]
        out, before = [], a
        if self.sign == 0:
            self.sign = _sign(g(a)[0]) or _sign(values[0])
        for t, value in zip(points, g(np.array(points)), strict=True):
            sign = _sign(value)
            if sign and self.sign and sign != self.sign and self.event.direction in (0, sign):
                out.append((before, t))
            self.sign, before = sign or self.sign, t
        return out

    def _refined(self, t, g, length, at):
        """The interpolation between two steps is less accurate than a step: go there by a step, and correct the time."""
        stepper, d = self.stepper, 1e-4 * length
        low, high = max(stepper.step_times[at], t - d), min(stepper.step_times[at + 1], t + d)
        if self.initial_event:  # g is divided by the time; its slope at a root is that of the function over the time
            scale = t - stepper.start[0]
        slope = float((g(high) - g(low))[0]) / (high - low) * (scale if self.initial_event else 1.0)
        for _ in range(2):
            value = float(self.g(t, *stepper.state_at(t)))
            move = value / slope if slope else 0.0
            if not abs(move) < 1e-3 * length:
                break
            t = min(max(t - move, stepper.step_times[at]), stepper.step_times[at + 1])
        return t


def _sign(x):
    return int(x > 0) - int(x < 0)


def _far(coefficients):
    """True if the constant term is larger than all that is added to it: no root."""
    return abs(coefficients[0]) > 1.5 * abs(coefficients[1:]).sum()


@cache
def _chebyshev():
    """The points in (0, 1), from left to right, and the matrix that turns values there into coefficients of Chebyshev polynomials."""
    import numpy as np

    angles = np.pi * (np.arange(CHEBYSHEV_POINTS)[::-1] + 0.5) / CHEBYSHEV_POINTS
    matrix = 2 / CHEBYSHEV_POINTS * np.cos(np.outer(np.arange(CHEBYSHEV_POINTS), angles))
    matrix[0] /= 2
    return (1 + np.cos(angles)) / 2, matrix


def _between(coefficients):
    """Points of (0, 1) that separate the roots of the polynomial."""
    import numpy as np

    if _far(coefficients) or not np.isfinite(coefficients).all():
        return []
    size = np.abs(coefficients).max()
    kept = coefficients[: int(np.flatnonzero(np.abs(coefficients) > 1e-15 * size)[-1]) + 1] if size else coefficients[:1]
    roots = np.polynomial.chebyshev.chebroots(kept)
    roots = np.sort(roots.real[(np.abs(roots.imag) < 1e-6) & (np.abs(roots.real) <= 1 + 1e-6)])
    return (1 + (roots[:-1] + roots[1:]) / 2) / 2


def _root(g, a, b):
    """The root between a and b, where the signs differ, to round-off: false position with halving (the Illinois rule), then bisection."""
    ga, gb, side = g(a), g(b), 0
    for n in range(200):
        if abs(b - a) <= 2.0**-52 * max(abs(a), abs(b)) or ga == 0:
            return a if ga == 0 else (a + b) / 2
        t = (a + b) / 2 if n % 4 == 3 or ga * gb >= 0 else (a * gb - b * ga) / (gb - ga)
        if not min(a, b) < t < max(a, b):
            t = (a + b) / 2
        value = g(t)
        if value == 0:
            return t
        if (value > 0) == (gb > 0):
            b, gb, ga, side = t, value, ga / 2 if side == 1 else ga, 1
        else:
            a, ga, gb, side = t, value, gb / 2 if side == -1 else gb, -1
    return (a + b) / 2
