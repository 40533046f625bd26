"""The exact solution of a model as a method of integration, and the error of one evaluation of it.

An exact solution is exact in its formula only. Rounding acts like a perturbation of its arguments,
above all of the phase: after a time t the phase of a frequency n is off by a few round-offs of n t,
near a separatrix by very many, and evaluating the formula again at the same numbers does not show
it, since both evaluations round alike. So the formula is evaluated at numbers a few round-offs
away: it is smooth there, and what is not smooth in its values is rounding. Whether it is a solution
of this model at all is checked by comparing its derivative in time with the right-hand side.
"""

import math
from functools import cache
from math import copysign, frexp, ldexp

from ...algebra.late import np
from .base import SMALLEST_SCALE, FastRun, Floats, Stepper, System

EPS = 2.0**-52
NO_VALUE = ArithmeticError, ValueError, TypeError  # errors of a formula near the end of its domain
UNKNOWN = 1.0  # the error where the formula has no values nearby
# lines through the given numbers; the most last digits by which a number moves along one
LINES, FARTHEST = 6, 15
STRAIGHT = 2e-9  # rad: a phase that moves by this much curves a line by its square, 4e-18
SAFETY_FACTOR = 4.0  # factor on the largest of LINES deviations from a straight line
# round-offs of a state and of its phase that are the same on all lines, as of a constant
ROUND_OFFS = 2.0
# irregular fractions of the time at which the sizes of the states are sampled
FRACTIONS = 0.0371, 0.131, 0.269, 0.417, 0.556, 0.683, 0.791, 0.927
# steps of the two difference quotients in time, in units of the time in which a state changes by
# its size, and the least step as a part of the time
STEPS, LEAST_STEP = (2.0**-9, 2.0**-11), 2.0**-36
AGREEMENT = 64.0  # how many times closer two such quotients are to each other than to the rhs
# residuals, relative to the largest rates, below which a formula is a solution: the accuracy of the
# difference quotients after short times, and what the phase leaves of it after long ones
LEAST_RESIDUAL, LEAST_LATE_RESIDUAL = 1e-10, 1e-3
LEAST_NOISE = 64.0  # round-offs: the least rounding of a value that a difference quotient shows
# regions of starts and times that are remembered; an offset that lets an exponent carry the sign;
# the factor by which the error at the places below must be less than the tolerance
KNOWN, SHIFT, REGION_FACTOR = 1024, 2000.0, 64.0
# the places in a region at which the error is estimated: fractions of its longest time and of the
# power of 2 of a start, the latter small since an orbit might not be bound with larger speeds, and
# with many digits since numbers of few digits round less
PLACES = (0.9731562, 0.5312907), (0.7120448, 0.5698343)


class Exact(Stepper):
    """The exact solution of the model: one step, inside which every state is exact too."""

    def step(self, limit: float = math.inf) -> None:
        self.x, self.t, self.calls = self.system.solution(self.goal - self.t, self.x), self.goal, 1
        self.step_times.append(self.t)

    @staticmethod
    def fast_run(system: System, tolerance: float) -> FastRun:
        return system.solution

    def state_at(self, t: float) -> Floats:
        start, x = self.start
        self.calls += 1
        return self.system.solution(t - start, x)

    def interpolate(self, n: int, times: "np.ndarray") -> "np.ndarray":
        start, x = self.start
        self.calls += len(times)
        return self.system.solutions(times - start, x)


# -- the error of one evaluation


def estimated_error(system: System, t: float, x0: Floats, x1: Floats | None = None) -> float:
    """The error of the exact solution, ``x1`` if known, at the time ``t`` after the start ``x0``:
    that of the worst state, relative to its largest size during the motion; 1 where it cannot be
    estimated. It depends on these numbers only, and takes about 45 evaluations.
    """
    try:
        x1 = x1 or system.solution(t, x0)
        size, pace = _size_and_pace(system, t, x0, x1)
        errors = rounding(system, t, x0, x1, pace), residual(system, t, x0, size, pace)
        worst = max((a + b) / s for a, b, s in zip(*errors, size, strict=True))
    except NO_VALUE:
        return UNKNOWN
    return worst if math.isfinite(worst) else UNKNOWN


def within(system: System, t: float, x0: Floats, rtol: float) -> bool:
    """True if the estimated error is at most ``rtol``.

    x0 : a tuple. The error is estimated once for the region of all times and starts with the same
        signs and powers of 2, at two places in it; where it is not clearly below ``rtol`` there, at
        these numbers themselves. So the result does not depend on earlier calls.
    """
    known = vars(system)
    if known.get("exact_last") == (rtol, t, x0):  # asked again for the same run
        return True
    errors = known.setdefault("exact_errors", {})
    region = frexp(t)[1], *[copysign(frexp(v)[1] + SHIFT, v) if v else 0.0 for v in x0]
    error = _remembered(errors, region, lambda: _error_in(system, *region))
    if error > rtol / REGION_FACTOR:
        error = _remembered(errors, (t, x0), lambda: estimated_error(system, t, x0))
        if error > rtol:
            return False
    known["exact_last"] = rtol, t, x0
    return True


def _remembered(errors, key, estimate):
    found = errors.get(key)
    if found is None:
        found = estimate()
        if len(errors) >= KNOWN:
            errors.clear()
        errors[key] = found
    return found


def _error_in(system, until, *powers):
    """The larger one of the errors at two places in a region."""
    errors = []
    for time, part in PLACES:
        x0 = [copysign(ldexp(part, int(abs(n) - SHIFT)), n) if n else 0.0 for n in powers]
        errors.append(estimated_error(system, time * ldexp(1.0, min(until, 1023)), tuple(x0)))
    return max(errors)


def _size_and_pace(system, t, x0, x1):
    """The largest size of each state, and the largest rate in units of these, on the way."""
    times = (0.0, *(f * t for f in FRACTIONS), t)
    rows = [x0, *(system.solution(u, x0) for u in times[1:-1]), x1]
    size = tuple([max(map(abs, column)) or SMALLEST_SCALE for column in zip(*rows, strict=True)])
    paces = [
        abs(r) / s
        for u, x in zip(times, rows, strict=True)
        for r, s in zip(_rates(system, u, x), size, strict=True)
    ]
    return size, max(1 / (t or 1.0), *paces)


def _rates(system, t, x):
    """The rates of the states; 0 at a singular place, through which a formula may pass."""
    try:
        found = system.rates(t, x)
    except NO_VALUE:
        found = (math.nan,)
    return found if math.isfinite(sum(found)) else (0.0,) * len(x)


def rounding(system: System, t: float, x0: Floats, x1: Floats, pace: float) -> list[float]:
    """The error of each state by rounding: how far values at numbers near these are from a straight
    line, plus a few round-offs of the phase. On half of the lines the numbers move by a few
    round-offs, on the other half as far as it stays straight: log(1 + c) is the same for many c.
    """
    given, off = (t, *x0, *system.p), [0.0] * len(x0)
    reach = max(1.0, STRAIGHT / (EPS * FARTHEST * (1 + pace * abs(t))))
    for number, line in enumerate(_lines(len(given))):
        far = math.floor(reach) if number % 2 else 1
        # these sums are exact: their rounding would be mistaken for that of the formula
        moves = [far * n * math.ulp(a) if a else 0.0 for n, a in zip(line, given, strict=True)]
        near = _value(system, [a + b for a, b in zip(given, moves, strict=True)])
        # not as far on the other side, where the same digits would be rounded
        other = _value(system, [a - 3 * b for a, b in zip(given, moves, strict=True)])
        rows = zip(off, x1, near, other, strict=True)
        off = [max(d, abs(x - (3 * u + v) / 4)) for d, x, u, v in rows]
    return [
        SAFETY_FACTOR * d + ROUND_OFFS * EPS * (abs(x) + abs(t * rate))
        for d, x, rate in zip(off, x1, _rates(system, t, x1), strict=True)
    ]


@cache
def _lines(count):
    """Unrelated directions in the space of ``count`` numbers, in round-offs of each."""
    from random import Random  # late: a short run does not need it

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
        pass  # it cannot be traced, or has no value here, as (-2)**p.n beside a whole number
    return system.solution(given[0], tuple(given[1 : len(system.model.states) + 1]))


def residual(system: System, t: float, x0: Floats, size: Floats, pace: float) -> list[float]:
    """The error of each state if the formula is not a solution of the model: its derivative in time
    less the right-hand side, times the whole time. Where that is no more than rounding it is the
    rounding of the values, which a difference over a short time shows: c^2 (sqrt(1 + u) - 1) is the
    same for all numbers near these where u is very small, but not right.

    At the start the value itself is compared. size, pace : from :func:`_size_and_pace`
    """
    worst = [abs(u - v) for u, v in zip(system.solution(0.0, x0), x0, strict=True)]
    worst = [d if d > LEAST_RESIDUAL * s else 0.0 for d, s in zip(worst, size, strict=True)]
    early = 1 / pace
    limits = LEAST_RESIDUAL, LEAST_RESIDUAL, LEAST_LATE_RESIDUAL
    for u, least in zip((0.37 * early, min(0.83 * t, 7.1 * early), t), limits, strict=True):
        x = system.solution(u, x0)
        try:
            rates = system.rates(u, x)
            # with the round-off of the states, which is large near an equilibrium
            moved = system.rates(u, tuple([v * (1 + AGREEMENT * EPS) for v in x]))
        except NO_VALUE:
            continue
        first, second = (max(h / pace, LEAST_STEP * u) for h in STEPS)
        one, two = _rate(system, u, x0, first), _rate(system, u, x0, second)
        for n, (a, b, rate, near, s) in enumerate(zip(one, two, rates, moved, size, strict=True)):
            off = min(abs(a - rate), abs(b - rate))
            noise = (abs(b - rate) - abs(near - rate)) * second
            # later the error of the phase would count as noise
            if least == LEAST_RESIDUAL and noise > LEAST_NOISE * EPS * s:
                worst[n] = max(worst[n], SAFETY_FACTOR * noise)
            # less is the error of the difference quotients
            if off > max(least * pace * s, AGREEMENT * abs(a - b), abs(near - rate)):
                worst[n] = max(worst[n], SAFETY_FACTOR * off * t)
    return worst


def _rate(system, t, x0, h):
    """The derivative in time of the exact solution, by central differences of order 4."""
    h = (t + h) - t  # as rounded in the times
    a, b, c, d = (system.solution(t + n * h, x0) for n in (-2, -1, 1, 2))
    return [(8 * (w - v) - (z - u)) / (12 * h) for u, v, w, z in zip(a, b, c, d, strict=True)]
