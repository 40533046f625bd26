"""Steps that end where the rates change their formula by the states, as at the end of a spring's
play: the error of a step across such a place is not proportional to its tolerance, and may be a
hundred times that; steps up to it and from it on are as accurate as any.
"""

from bisect import bisect_right
from collections.abc import Callable
from itertools import pairwise
from math import copysign, hypot, inf, nextafter, ulp

from ..algebra.compile import Compiled
from ..algebra.scalars import Scalar
from ..algebra.trace import COMPARISONS
from .analytic import absolutes, varying
from .chebyshev import root
from .methods.base import Floats, StepError, Stepper, System, TracedRates

TRIES = 60  # the most by which the steps for crossings may outnumber the others
AROUND = 2  # units in the last place of the time about a crossing, which is found to one
WAYS = 1, 4, 16  # multiples of the room about a crossing, by which it is passed
SLIDING = 3  # steps in which a motion that slides passes over a place again
SHORTEST = 1e3  # units in the last place of the time: no step could be much shorter
LIMIT = 10.0  # tolerances by which a step may differ from its halves
EPS = 2.0**-53  # the part by which each side of a comparison may be off
JUMP = 1e-6  # relative change of the rates between neighbouring states that is a jump
FROM_ZERO = 1e-100  # part of its rate by which a state that is zero is moved off a border
SHORT, DIGITS = 1e-6, 16  # part of the time by which to look ahead; last digits about a border
NEAR = 4  # multiples of that room: a crossing so near the end of a step needs no stop


def choices(traced: TracedRates) -> list[tuple[Scalar, Scalar]]:
    """The pairs (a, b) of steps or numbers by whose order the rates choose between formulas."""
    found = []
    for s in varying(traced):
        if s.op in COMPARISONS:
            found.append(tuple(s.args))
        elif s.op == "table":
            found += [(s.args[0], place) for place in s.args[1].places]
        found += [(x, 0.0) for x in absolutes(s)]
    return found


def compiled_choices(traced: TracedRates) -> Callable[..., Floats]:
    """The function of all arguments that returns the values of :func:`choices`, in order."""
    rhs, leaves = traced.rhs, [x for pair in traced.choices for x in pair]
    return Compiled("choices", rhs.parameters, rhs.trace, leaves).on_floats


def off_a_border(system: System, t: float, x: Floats) -> Floats:
    """The state ``x``, or the one beside it into which its rates lead where others hold there: at
    rest on a rough floor the friction is that of neither direction.
    """
    if not system.traced.choices:
        return x
    rates = system.rates(t, x)
    beside = tuple([
        nextafter(v, copysign(inf, r)) if v and r else v or r * FROM_ZERO
        for v, r in zip(x, rates, strict=True)
    ])  # fmt: skip
    others = system.rates(t, beside)
    jumps = any(abs(a - b) > JUMP * (abs(a) + abs(b)) for a, b in zip(rates, others, strict=True))
    return beside if jumps else x


def distances(system: System) -> Callable[[float, Floats], list[float]]:
    """The function ``(t, x)`` of the distances from each place where the rates change formula."""
    run, p = system.traced.compiled_choices, system.p

    def at(t, x):
        values = run(t, *x, *p)
        return [a - b for a, b in zip(values[::2], values[1::2], strict=True)]

    return at


def unsettled(stepper: Stepper, end: float) -> float:
    """The summed differences, relative to the scales, of the steps up to the time ``end`` that pass
    over such a place from two halves of each: a step that was shortened until its error estimate
    was small may have got there by chance. Steps of a motion that slides, one of which soon leads
    back, do not count. The effect of :func:`_last_digit` is added.
    """
    system, count = stepper.system, bisect_right(stepper.step_times, end) - 1
    run, p, ends = system.traced.compiled_choices, system.p, stepper.steps[: count + 1]
    ends = [(t, *x) for t, _, *x in ends] + [(stepper.t, *stepper.x)] * (count == len(ends))
    values = [run(*point, *p) for point in ends]
    signs = [[a > b for a, b in zip(v[::2], v[1::2], strict=True)] for v in values]
    crossed = [n for n, (a, b) in enumerate(pairwise(signs)) if a != b]
    off, largest, squares = [0.0] * len(stepper.x), 0.0, [0.0] * len(stepper.x)
    for before, n, after in zip([-inf, *crossed], crossed, [*crossed[1:], inf], strict=False):
        begin, h = stepper.steps[n][:2]
        if min(n - before, after - n) <= SLIDING:
            continue
        lost = _last_digit(system, ends[n], ends[n + 1], values[n], values[n + 1])
        squares = [s + v * v for s, v in zip(squares, lost, strict=True)]
        if h > SHORTEST * ulp(begin + h):
            assert stepper.halved is not None
            apart = stepper.halved(n)
            if max(map(abs, apart)) > LIMIT * stepper.tolerance:
                off = [a + b for a, b in zip(off, apart, strict=True)]
                largest = max(largest, *map(abs, off))
    rows = zip(squares, stepper.scales, strict=True)
    return hypot(largest, max(s**0.5 / (scale or 1.0) for s, scale in rows))


def _last_digit(system, before, after, first, last):
    """How much each state is off between two points (time, *state), with ``first`` and ``last``
    values of :func:`choices`, since their last digit decides when the rates jump: the jump for that
    time.
    """
    run, p = system.traced.compiled_choices, system.p
    moved, late = run(before[0], *after[1:], *p), 0.0  # the change by the states alone
    columns = [w[k::2] for w in (first, last, moved) for k in (0, 1)]
    for a, b, c, d, u, v in zip(*columns, strict=True):
        if (a > b) != (c > d) and (u, v) != (a, b):
            late = max(late, (abs(c) + abs(d)) * EPS / abs((c - d) - (a - b)))
    late *= after[0] - before[0]
    rates = system.rates(before[0], before[1:]), system.rates(after[0], after[1:])
    return [late * abs(m - k) for k, m in zip(*rates, strict=True)]


class Crossings:
    """Takes the steps of a stepper so that they end where the rates change their formula.

    tries : the number of steps that were repeated or passed over a crossing, minus the others
    """

    def __init__(self, stepper: Stepper):
        self.stepper, self.away, self.tries = stepper, distances(stepper.system), 0
        stepper.around = AROUND
        self.short = SHORT * (stepper.goal - stepper.t)
        self.room = 2 * AROUND * ulp(max(abs(stepper.t), abs(stepper.goal)))

    def step(self, limit: float) -> None:
        """At most ``limit`` steps; :class:`StepError` where the motion slides or chatters there."""
        stepper = self.stepper
        for _ in range(int(min(limit, stepper.max_steps))):
            if stepper.t >= stepper.goal:
                return
            scales = stepper.scales
            try:
                stepper.step(1)
                length = stepper.t - stepper.steps[-1][0]
                # steps that do not change the last digit of what is compared would never end
                if stepper.t < stepper.goal and length < self.short and length < self._last_digit():
                    raise StepError("the step became too small to go on")
            except StepError:
                if not self._pass():
                    raise
                self.tries += 2
                continue
            stop = self._stop()
            if self.tries > TRIES:
                raise StepError("the rates change their formula again and again")
            if stop is None:
                self.tries = max(self.tries - 1, 0)
            else:
                stepper.back_to(len(stepper.steps) - 1, (stop,), scales)
                self.tries += 2

    def _last_digit(self):
        """The longest time for which the last digits of what is compared here stay the same on the
        way to its border, as those of a place far from the origin: in less no step can pass.
        """
        system, t, x = self.stepper.system, self.stepper.t, self.stepper.x
        moves = zip(x, self.stepper.rates, strict=True)
        run, p, longest = system.traced.compiled_choices, system.p, 0.0
        here = run(t, *x, *p)
        there = run(t + self.short, *(v + self.short * k for v, k in moves), *p)
        for a, b, c, d in zip(here[::2], here[1::2], there[::2], there[1::2], strict=True):
            digit, away, change = EPS * (abs(a) + abs(b)), a - b, (c - d) - (a - b)
            if abs(away) <= DIGITS * digit and away * change <= 0 != change:
                longest = max(longest, 2 * digit * self.short / abs(change))
        return longest

    def _changed(self, before, after):
        """{number of a distance that changes its sign: the part of the way to it, as if linear}."""
        both = zip(self.away(*before), self.away(*after), strict=True)
        # far from the origin the first state may lie on the border itself
        return {k: a / (a - b) for k, (a, b) in enumerate(both) if (a <= 0 < b) or (b < 0 <= a)}

    def _stop(self):
        """The time at which the last step should have ended; None if its end is right."""
        stepper = self.stepper
        begin, _, *x = stepper.steps[-1]
        if stepper.t - begin <= NEAR * self.room:
            return None
        times = [
            root(lambda t, k=k: self.away(t, stepper.state_at(t))[k], begin, stepper.t)
            for k in self._changed((begin, x), (stepper.t, stepper.x))
        ]
        first = min(times, default=stepper.t)
        return max(first, begin + self.room) if first < stepper.t - NEAR * self.room else None

    def _pass(self):
        """Go past a crossing next to the last state, where no step was possible; False if none."""
        stepper, before = self.stepper, (self.stepper.t, self.stepper.x)
        room = max(self.room, self._last_digit())
        for rooms in WAYS if stepper.steps and self.tries < TRIES else ():
            t = stepper.t + rooms * room
            ahead = [v + (t - stepper.t) * k for v, k in zip(before[1], stepper.rates, strict=True)]
            parts = self._changed(before, (t, ahead)).values()
            if parts:
                stepper.pass_stop(t, min(parts))
                stepper.step_times[-1] = t
                stepper.resume()
                return True
        return False
