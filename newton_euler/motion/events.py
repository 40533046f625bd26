"""Events: the times at which a function of the state goes through zero, found inside the steps of a
trajectory.

In each step the function is sampled at Chebyshev points. If these resolve it, all roots of the
interpolating polynomial are known, also two in one step, which a comparison of signs at both ends
misses; if not, the interval is halved. J. P. Boyd, Computing zeros on a real interval through
Chebyshev expansion and polynomial rootfinding, SIAM J. Numer. Anal. 40 (2002) 1666.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

from ..algebra.codegen.portable import Portable

CHEBYSHEV_POINTS = 12
# the function is resolved if its last two coefficients are smaller than this part of the largest
RESOLUTION = 1e-7
MAX_HALVINGS = 8


@dataclass(frozen=True)
class Event(Portable):
    """A zero of ``function(s, p, t)`` to be found during a motion: impact, loss of contact, end of
    sliding, a turning point.

    function : of the states, the parameters and the time, as in a :class:`Model`; smooth
    direction : 1 if only zeros count where it grows, -1 where it falls, 0 both
    terminal : True if the motion ends there
    then : a function ``(s, p, t)`` that returns the model and the start with which the motion goes
        on, ``(model, start)`` or, to change the events as well, ``(model, start, events)``; if it
        returns None, the motion ends. If the right-hand side becomes another, this event is no
        longer looked for.
    name : by which the motion lists it

    >>> landing = Event(lambda s, p, t: s.h, direction=-1, terminal=True, name="landing")
    """

    function: Callable
    direction: int = 0
    terminal: bool = False
    then: Callable | None = None
    name: str = ""

    @property
    def ends(self) -> bool:
        """True if the event ends the segment of the trajectory."""
        return self.terminal or self.then is not None


@dataclass(frozen=True)
class Occurrence:
    """An event that happened: its ``name``, the time ``t``, and the ``state`` by name, before
    ``then`` changed it.
    """

    name: str
    t: float
    state: dict


class EventLocator:
    """Finds one event in the steps of a stepper, in their order.

    at_start : True if the segment starts with this very event, at a zero of the function, which is
        then divided by the time since the start
    """

    def __init__(self, event, stepper, at_start):
        self.direction, self.stepper, self.at_start = event.direction, stepper, at_start
        self.g = stepper.system.function(event.function)
        self.sign = 0 if at_start else _sign(self.g(stepper.t, *stepper.x))

    def roots(self, n):
        """The times of the event in step ``n``, in order."""
        import numpy as np

        a, b = self.stepper.step_times[n : n + 2]
        start = self.stepper.start[0]
        # the first time that differs from the start by more than round-off
        nearest = start + max(1e-13 * (b - a), 4e-16 * abs(start))

        def g(times):
            times = np.atleast_1d(times)
            if self.at_start:
                times = np.maximum(times, nearest)
            x = self.stepper.interpolate(n, times)
            try:
                values = np.broadcast_to(np.asarray(self.g(times, *x), dtype=float), times.shape)
            except ValueError:  # the function branches on values
                columns = zip(times.tolist(), *x.tolist(), strict=True)
                values = np.array([float(self.g(*column)) for column in columns])
            return values / (times - start) if self.at_start else values

        out = []
        for left, right in self._brackets(g, a, b):
            t = self._refined(_root(lambda t: float(g(t)[0]), left, right), g, a, b)
            # the end of a bracket may lie beyond b by round-off
            if a <= t <= b * (1 + 1e-15) + 1e-300 and (not self.at_start or t > start):
                out.append(min(t, b))
        return out

    def _brackets(self, g, a, b, depth=0):
        """Intervals over which the sign changes in the direction that counts."""
        import numpy as np

        nodes, transform = _chebyshev()
        values = g(a + (b - a) * nodes)
        c = transform @ values
        sizes = np.abs(c)
        unresolved = sizes[-2:].max() > RESOLUTION * sizes.max() > 0
        if depth < MAX_HALVINGS and unresolved and not _has_no_root(c):
            middle = (a + b) / 2
            return self._brackets(g, a, middle, depth + 1) + self._brackets(g, middle, b, depth + 1)
        if self.sign == 0:
            self.sign = _sign(g(a)[0]) or _sign(values[0])
        ends = np.array([*(a + (b - a) * x for x in _between_roots(c)), b])
        out, before = [], a
        for t, sign in zip(ends.tolist(), map(_sign, g(ends)), strict=True):
            if sign and self.sign and sign != self.sign and self.direction in (0, sign):
                out.append((before, t))
            self.sign, before = sign or self.sign, t
        return out

    def _refined(self, t, g, a, b):
        """The root near ``t`` by Newton's method with the state after a step to ``t``, since the
        interpolation is less accurate than a step.
        """
        length = b - a
        # a central difference: cancellation and the third derivative both stay below 1e-8
        low, high = max(a, t - 1e-4 * length), min(b, t + 1e-4 * length)
        slope = float((g(high) - g(low))[0]) / (high - low)
        # g is divided by the time since the start: at a root the slope is larger by that factor
        if self.at_start:
            slope *= t - self.stepper.start[0]
        # two steps: the first root is already good to the error of the interpolation
        for _ in range(2):
            move = float(self.g(t, *self.stepper.state_at(t))) / slope if slope else 0.0
            if not abs(move) < 1e-3 * length:
                break
            t = min(max(t - move, a), b)
        return t


def _sign(x):
    return int(x > 0) - int(x < 0)


def _has_no_root(c):
    """True if the constant coefficient is larger than all others together."""
    # no Chebyshev polynomial exceeds 1; 1.5 leaves a margin for the terms that were cut off
    return abs(c[0]) > 1.5 * abs(c[1:]).sum()


@cache
def _chebyshev():
    """The points in (0, 1), from left to right, and the matrix from values there to coefficients of
    Chebyshev polynomials.
    """
    import numpy as np

    counts = np.arange(CHEBYSHEV_POINTS)
    angles = np.pi * (counts[::-1] + 0.5) / CHEBYSHEV_POINTS
    matrix = 2 / CHEBYSHEV_POINTS * np.cos(np.outer(counts, angles))
    matrix[0] /= 2
    return (1 + np.cos(angles)) / 2, matrix


def _between_roots(c):
    """Points of (0, 1) that separate the roots of the polynomial with these coefficients."""
    import numpy as np

    if _has_no_root(c) or not np.isfinite(c).all():
        return []
    # trailing coefficients of round-off would make the companion matrix singular
    significant = np.flatnonzero(np.abs(c) > 1e-15 * np.abs(c).max())
    roots = np.polynomial.chebyshev.chebroots(c[: max(significant, default=0) + 1])
    # a double root may come out as a complex pair, 1e-8 apart; 1e-6 is generous, as signs decide
    roots = np.sort(roots.real[(np.abs(roots.imag) < 1e-6) & (np.abs(roots.real) <= 1 + 1e-6)])
    return (1 + (roots[:-1] + roots[1:]) / 2) / 2


def _root(g, a, b):
    """The root between a and b, where the signs differ, to round-off: regula falsi by the Illinois
    rule (M. Dowell, P. Jarratt, BIT 11 (1971) 168), and every fourth time bisection.
    """
    ga, gb, side = g(a), g(b), 0
    for n in range(200):
        if ga == 0:
            return a
        if abs(b - a) <= 2.0**-52 * max(abs(a), abs(b)):
            break
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
