"""The exact solution of a model as a method of integration, and the error of one evaluation of it.

An exact solution is exact in its formula only. Rounding in it acts like a change of the numbers
that go in, above all of the phase: after a time t that of a frequency n is lost by some round-offs
of n t, next to a separatrix by very many, and no comparison of the formula with itself at these
same numbers shows it, since both sides round alike. So the formula is evaluated at numbers a few
round-offs away: it is smooth there, what is not smooth in its values is rounding. Whether it is a
solution of this model at all, its rate in time tells, compared with the right-hand side.
"""

import math
from functools import cache
from math import copysign, frexp, ldexp

from .base import SMALLEST_SCALE, Stepper

EPS = 2.0**-52
NO_VALUE = ArithmeticError, ValueError, TypeError  # of a formula next to the end of its domain
UNKNOWN = 1.0  # the error where the formula has no values nearby
# lines through the given numbers, each with two evaluations; the multiples of the last digit by
# which a number moves along a line are at most this
LINES, FARTHEST = 6, 15
STRAIGHT = 2e-9  # part of a radian by which a phase may move along a straight line, squared 4e-18
SAFETY_FACTOR = 4.0  # on the largest deviation from a straight line, of LINES deviations
# round-offs of a state, and of the phase, which are the same on all lines where constants of the
# formula are rounded
ROUND_OFFS = 2.0
# irregular fractions of the time, at which the sizes of the states are looked at
FRACTIONS = 0.0371, 0.131, 0.269, 0.417, 0.556, 0.683, 0.791, 0.927
# steps of the two differences in time, in units of the time in which a state changes by its size
STEPS, LEAST_STEP = (2.0**-9, 2.0**-11), 2.0**-36  # the last is a part of the time reached
AGREEMENT = 64.0  # of two such differences, times as near to each other as to the right-hand side
# residuals, relative to the largest rates, below which a formula is a solution: what differences
# show after short times, and what is left of that by the phase after long ones
LEAST_RESIDUAL, LEAST_LATE_RESIDUAL = 1e-10, 1e-3
LEAST_NOISE = 64.0  # round-offs of a value that a difference shows
# regions kept; what is added to a power of 2 so that it takes a sign; the place in a region, of 0.5
# to 1; how much smaller than the tolerance the error has to be there
KNOWN, SHIFT, REGION_FACTOR = 1024, 2000.0, 64.0
# the places: parts of the longest time, and of the power of 2 of a start, small, as the speeds of
# an orbit might else be too large for it; no numbers of few digits, with which rounding is less
PLACES = (0.9731562, 0.5312907), (0.7120448, 0.5698343)


class Exact(Stepper):
    """The exact solution of the model: one step, inside which every state is exact too."""

    def step(self, limit=math.inf):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        self.x, self.t, self.calls = self.system.solution(self.goal - self.t, self.x), self.goal, 1
        self.step_times.append(self.t)

    @staticmethod
    def prepared_run(system, rtol, fallback):
        """The function that :func:`newton_euler.motion.integration.prepare` returns."""
        solution = system.solution

        def run(t, start):
            x = solution(t, start)
            return x if within(system, t, start, x, rtol) else fallback(t, start)

        return run

    def state_at(self, t):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        start, x = self.start
        self.calls += 1
        return self.system.solution(t - start, x)

    def interpolate(self, n, times):
        """See :class:`~newton_euler.motion.methods.base.Stepper`."""
        start, x = self.start
        self.calls += len(times)
        return self.system.solutions(times - start, x)


# -- the error of one evaluation


def estimated_error(system, t, x0, x1):
    """The error of the exact solution ``x1`` at the time ``t`` after the start ``x0``, of the worst
    state relative to its largest size during the motion: 1 where nothing is known.

    It depends on these numbers only, and takes about 45 evaluations.
    """
    try:
        size, pace = _size_and_pace(system, t, x0, x1)
        rows = zip(
            rounding(system, t, x0, x1, pace),
            residual(system, t, x0, size, pace),
            size,
            strict=True,
        )
        worst = max((a + b) / s for a, b, s in rows)
    except NO_VALUE:
        return UNKNOWN
    return worst if math.isfinite(worst) else UNKNOWN


def within(system, t, x0, x1, rtol):
    """True if the estimated error is at most ``rtol``.

    x0 : a tuple. The error is estimated once for all times and starts with the same signs and
        powers of 2, at one place among them; where it is not clearly below ``rtol`` there, at these
        numbers themselves. So the answer does not depend on what was asked before.
    """
    known = vars(system)
    if known.get("exact_last") == (rtol, t, x0):  # the same again, as by a loop that times it
        return True
    region = frexp(t)[1], *[copysign(frexp(v)[1] + SHIFT, v) if v else 0.0 for v in x0]
    error = known.setdefault("exact_errors", {}).get(region)
    if error is None:
        until, *powers = region
        error = max(_placed(system, ldexp(1.0, min(until, 1023)), powers, *p) for p in PLACES)
        _keep(known["exact_errors"], region, error)
    found = error <= rtol / REGION_FACTOR or _remembered(system, (t, x0), t, x0) <= rtol
    if found:
        system.exact_last = rtol, t, x0
    return found


def _placed(system, until, powers, time, part):
    """The error at one place in a region."""
    x0 = tuple(copysign(ldexp(part, int(abs(n) - SHIFT)), n) if n else 0.0 for n in powers)
    return _found(system, time * until, x0)


def _found(system, t, x0):
    try:
        return estimated_error(system, t, x0, system.solution(t, x0))
    except NO_VALUE:
        return UNKNOWN


def _remembered(system, key, t, x0):
    known = vars(system)["exact_errors"]
    error = known.get(key)
    return _keep(known, key, _found(system, t, x0)) if error is None else error


def _keep(known, key, error):
    if len(known) >= KNOWN:
        known.clear()  # what is forgotten is found again
    known[key] = error
    return error


def _size_and_pace(system, t, x0, x1):
    """The largest absolute value of each state, and the largest rate in units of these, at the ends
    and at some times between.
    """
    times = (0.0, *(f * t for f in FRACTIONS), t)
    rows = [x0, *(system.solution(u, x0) for u in times[1:-1]), x1]
    size = [max(map(abs, column)) or SMALLEST_SCALE for column in zip(*rows, strict=True)]
    paces = [
        abs(r) / s
        for u, x in zip(times, rows, strict=True)
        for r, s in zip(_rates(system, u, x), size, strict=True)
    ]
    return size, max(1 / (t or 1.0), *paces)


def _rates(system, t, x):
    """The rates of the states; 0 where the coordinates are singular, which a formula may pass."""
    try:
        found = system.rates(t, x)
    except NO_VALUE:
        found = (math.nan,)
    return found if math.isfinite(sum(found)) else (0.0,) * len(x)


def rounding(system, t, x0, x1, pace):
    """The error of each state by rounding: how far the values at numbers near these are off a
    straight line, plus some round-offs of the phase.

    On half of the lines the numbers move by some round-offs, on half by as much as leaves them
    straight: log(1 + c) has the same value for many c.
    """
    given, off = (t, *x0, *system.p), [0.0] * len(x0)
    reach = max(1.0, STRAIGHT / (EPS * FARTHEST * (1 + pace * abs(t))))
    for number, line in enumerate(_lines(len(given))):
        far = math.floor(reach) if number % 2 else 1
        # sums that are exact: their own rounding would be taken for that of the formula
        moves = [far * n * math.ulp(a) if a else 0.0 for n, a in zip(line, given, strict=True)]
        near = _value(system, [a + b for a, b in zip(given, moves, strict=True)])
        # not as far on the other side: there the same digits would be rounded
        other = _value(system, [a - 3 * b for a, b in zip(given, moves, strict=True)])
        rows = zip(off, x1, near, other, strict=True)
        off = [max(d, abs(x - (3 * u + v) / 4)) for d, x, u, v in rows]
    return [
        SAFETY_FACTOR * d + ROUND_OFFS * EPS * (abs(x) + abs(t * rate))
        for d, x, rate in zip(off, x1, _rates(system, t, x1), strict=True)
    ]


@cache
def _lines(count):
    """Directions in the space of ``count`` numbers, in round-offs of each, that have nothing to do
    with each other.
    """
    from random import Random  # here: a short run does not need it

    chance = Random(1)
    return tuple(
        tuple(chance.choice((-1, 1)) * chance.randint(1, FARTHEST) for _ in range(count))
        for _ in range(LINES)
    )


def _value(system, given):
    """The exact solution at the time, the start and the parameters in one list."""
    try:
        found = system.exact_on_floats(*given)
        if math.isfinite(sum(found)):
            return found
    except NO_VALUE:
        pass  # it cannot be traced; or the parameters moved, as an exponent that was a whole number
    return system.solution(given[0], tuple(given[1 : len(system.model.states) + 1]))


def residual(system, t, x0, size, pace):
    """The error of each state that a formula makes which is no solution of the model: its rate in
    time less the right-hand side, times the whole time. If that is no more than rounding it is the
    rounding of the values, which a difference over a short time shows: c^2 (sqrt(1 + u) - 1) is the
    same for all numbers near these where u is very small, but not right.

    At the start its value is compared instead. size, pace : as from :func:`_size_and_pace`
    """
    worst = [abs(u - v) for u, v in zip(system.solution(0.0, x0), x0, strict=True)]
    worst = [d if d > LEAST_RESIDUAL * s else 0.0 for d, s in zip(worst, size, strict=True)]
    early = 1 / pace
    for u, least in (
        (0.37 * early, LEAST_RESIDUAL),
        (min(0.83 * t, 7.1 * early), LEAST_RESIDUAL),
        (t, LEAST_LATE_RESIDUAL),
    ):
        x = system.solution(u, x0)
        try:
            rates = system.rates(u, x)
            # what the round-off of the states makes of them, as next to an equilibrium
            moved = system.rates(u, [v * (1 + AGREEMENT * EPS) for v in x])
        except NO_VALUE:
            continue
        first, second = (max(h / pace, LEAST_STEP * u) for h in STEPS)
        one, two = _rate(system, u, x0, first), _rate(system, u, x0, second)
        for n, (a, b, rate, near, s) in enumerate(zip(one, two, rates, moved, size, strict=True)):
            off = min(abs(a - rate), abs(b - rate))
            noise = (abs(b - rate) - abs(near - rate)) * second
            if least == LEAST_RESIDUAL and noise > LEAST_NOISE * EPS * s:  # later there is phase
                worst[n] = max(worst[n], SAFETY_FACTOR * noise)
            # else it is the error of the differences
            if off > max(least * pace * s, AGREEMENT * abs(a - b), abs(near - rate)):
                worst[n] = max(worst[n], SAFETY_FACTOR * off * t)
    return worst


def _rate(system, t, x0, h):
    """The rate in time of the exact solution, by differences of order 4 about ``t``."""
    h = (t + h) - t  # as it is in the times
    a, b, c, d = (system.solution(t + n * h, x0) for n in (-2, -1, 1, 2))
    return [(8 * (w - v) - (z - u)) / (12 * h) for u, v, w, z in zip(a, b, c, d, strict=True)]
