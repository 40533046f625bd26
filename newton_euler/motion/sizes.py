"""The natural size of a state that happens to be nearly zero. Errors are relative to the size of
each state, but the rate of nutation of a steady precession is zero, and still has an error.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import TypeAlias

from .methods.base import Floats, System

# fraction of its natural size above which the scale of a state is not below this fraction either
NATURAL_PART = 1e-3
ROUND_OFF = 2e-16  # round-off that its rate brings into a state, as a fraction of its natural size
# multiples of this: a state below the first that nothing drives is mere round-off, as the rate of
# nutation of a steady precession; the second is the error by one step, which grows like a random
# walk, and the third what all steps have in common (measured on 60 springs of 10 to 9000 steps)
NOTHING, FORCED, COMMON = 300.0, 2.0, 0.05
STEP_CALLS = 12  # evaluations of the rates in a step, about
TIME_SAFETY = 3.0  # factor on the error by round-off of the time; measured

Sizes: TypeAlias = tuple[Floats, Floats, Floats]  # as Trajectory.sizes returns them
There: TypeAlias = Callable[[Floats, set[int]], set[int]]


def natural_sizes(
    system: System, points: Iterable[tuple[float, Floats]], sizes: Floats, span: float
) -> tuple[Floats, Floats]:
    """The size of each state that follows from its coupling to the others, and the same with the
    coupling to time included: two tuples.

    It is the sum over j of abs(df_i/dx_j) size_j, divided by the fastest rate of the linearised
    motion. It does not depend on units, and is the size that the state would have if its terms did
    not cancel. The smallest sum of all points counts, since near a singular place it is arbitrarily
    large, as that of the speed of a rocket with almost no mass left.

    points : pairs (time, state) of the motion
    sizes : the largest absolute value of each state
    span : the time of the motion; rates below 1/span do not count
    """
    natural = with_time = (0.0,) * len(sizes)
    # the second time also with a step for states that are zero
    for _ in range(2):
        scale = [max(s, n) or 1.0 for s, n in zip(sizes, natural, strict=True)]
        terms, of_time, fastest = [math.inf] * len(sizes), [0.0] * len(sizes), 1 / span
        for t, x in points:
            try:
                columns = _derivatives(system, t, x, scale, span)
            except (ArithmeticError, ValueError):
                continue  # the rates have no value near this point
            *states, time = columns
            for i in range(len(sizes)):
                row = [abs(c[i]) for c in states]
                made = sum([a * s for a, s in zip(row, sizes, strict=True)])
                terms[i] = min(terms[i], made)
                of_time[i] = max(of_time[i], abs(time[i] * t))
            fastest = max(fastest, _spectral_radius(states, scale))
        terms = [x if x < math.inf else 0.0 for x in terms]  # 0 if no point has rates
        natural = tuple([x / fastest for x in terms])
        with_time = tuple([(x + y) / fastest for x, y in zip(terms, of_time, strict=True)])
        # a step of 1e-6 is appropriate for states of ordinary size
        if all(s or not n or 1e-3 < n < 1e3 for s, n in zip(sizes, natural, strict=True)):
            break
    return natural, with_time


def small(sizes: Sequence[float], natural: Floats) -> list[int]:
    """The numbers of the states that are small by cancellation, but not zero."""
    rows = enumerate(zip(sizes, natural, strict=True))
    return [k for k, (s, n) in rows if 0.0 < s <= NATURAL_PART * n]


def without_round_off(known: Sizes, there: There, rtol: float) -> Sizes:
    """The sizes ``known``, larger for the states that are mere round-off.

    there : a function that returns those of a set of numbers of states that are not, with their
        natural sizes; see :mod:`.drives`
    """
    sizes, natural = list(known[0]), known[1]
    nothing = [NOTHING * ROUND_OFF * n for n in natural]
    tiny = [k for k in small(sizes, natural) if sizes[k] < nothing[k]]
    for k in set(tiny) - there(natural, set(tiny)) if tiny else ():
        sizes[k] = min(nothing[k] / (rtol * NATURAL_PART), natural[k])
    return tuple(sizes), *known[1:]


def least_scales(sizes: Floats, natural: Floats, own: float) -> list[float]:
    """The least scale for the error of each state: for states that are small by cancellation a part
    of their own size; see :func:`natural_sizes`.

    own : fraction of the size of a state below which its errors do not count
    """
    scales = [max(own * s, NATURAL_PART * n) for s, n in zip(sizes, natural, strict=True)]
    for k in small(sizes, natural):
        scales[k] = NATURAL_PART * sizes[k]
    return scales


def reproduced(known: Sizes, again: Sizes, apart: Floats, rtol: float, there: There) -> Floats:
    """The sizes ``known``, larger for a state that is all error: one that nothing drives whose size
    is that of round-off, or depends on the tolerance.

    known, again : as :meth:`.Trajectory.sizes` returns them, at two tolerances
    apart : by how much the last states differ
    there : as in :func:`without_round_off`
    """
    found, natural = list(known[0]), known[1]
    cancel = set(small(found, natural))
    for k in cancel - there(natural, cancel):
        size, other, n = found[k], again[0][k], natural[k]
        nothing = NOTHING * ROUND_OFF * n
        noise = size < nothing or (apart[k] > size / 3 and size < 100 * nothing)
        if noise or not 0.5 < other / size < 2.0:
            made = max(nothing, min(size, other))
            found[k] = min(made / (rtol * NATURAL_PART), n)
    return tuple(found)


def are_settled(before: Floats | None, after: Floats) -> bool:
    """True if no size has become less than half."""
    return before is not None and all(2 * b >= a for a, b in zip(before, after, strict=True))


def as_natural(known: Sizes) -> Sizes:
    """The sizes ``known``, with natural sizes for the states that are small by cancellation."""
    sizes = list(known[0])
    for k in small(*known[:2]):
        sizes[k] = known[1][k]
    return tuple(sizes), *known[1:]


def round_off_over(calls: int) -> float:
    """The relative round-off in a state after this many calls of the rates."""
    steps = 1 + calls / STEP_CALLS
    return ROUND_OFF * (FORCED * steps**0.5 + COMMON * steps)


def forced_error(sizes: Floats, natural: Floats, calls: int) -> float:
    """The relative error that round-off forces on states small by cancellation."""
    return round_off_over(calls) * worst_ratio(sizes, natural)


def worst_ratio(sizes: Floats, natural: Floats) -> float:
    """The largest natural size over the size, of the states that are small by cancellation."""
    return max([natural[k] / sizes[k] for k in small(sizes, natural)], default=0.0)


def far_states(
    system: System, t: float, x: Floats, sizes: Floats, natural: Floats
) -> tuple[str, str]:
    """The names of the state smallest by cancellation, and of the far one that is the reason."""
    names, known = system.model.states, small(sizes, natural)
    worst = max(known, key=lambda k: natural[k] / sizes[k])
    columns = _derivatives(system, t, x, [s or 1.0 for s in sizes], 1.0)
    made = [abs(c[worst]) * s for c, s in zip(columns, sizes, strict=False)]
    return names[worst], names[made.index(max(made))]


def _derivatives(system, t, x, scale, span):
    """The derivatives of the rates by each state and by time, each a list, by differences."""
    rates, columns = system.rates(t, x), []
    for j, s in enumerate(scale):
        step = 1e-6 * s
        moved = x[j] + step
        beside = system.rates(t, (*x[:j], moved, *x[j + 1 :]))
        step = moved - x[j] or step
        column = [(b - a) / step for a, b in zip(rates, beside, strict=True)]
        if system.traced.surprises:  # the difference across a jump on one side is not a slope
            other = system.rates(t, (*x[:j], x[j] - step, *x[j + 1 :]))
            other = [(a - b) / step for a, b in zip(rates, other, strict=True)]
            column = [min(pair, key=abs) for pair in zip(column, other, strict=True)]
        columns.append(column)
    if system.autonomous:
        return [*columns, [0.0] * len(x)]
    later = t + 1e-6 * span
    beside = system.rates(later, x)
    return [*columns, [(b - a) / (later - t) for a, b in zip(rates, beside, strict=True)]]


def _spectral_radius(columns, scale):
    """An estimate of the spectral radius of the matrix of absolute values, by power iteration."""
    states = range(len(scale))
    rows = [[abs(c[i]) * s / scale[i] for c, s in zip(columns, scale, strict=True)] for i in states]
    # iteration with the square: the matrix of an oscillator swaps the states
    vector, norm = [1.0] * len(scale), 0.0
    for _ in range(2):
        once = [sum([a * v for a, v in zip(row, vector, strict=True)]) for row in rows]
        twice = [sum([a * v for a, v in zip(row, once, strict=True)]) for row in rows]
        largest = max(twice)
        if not 0.0 < largest < 1e300:
            return largest
        norm, vector = largest**0.5, [v / largest + 1e-12 for v in twice]
    return norm


def time_round_off(system: System, t: float, x: Floats, sizes: Floats, span: float) -> float:
    """The error, over the sizes, by round-off of the time: 1e9 s are known to 1e-7 s."""
    if system.autonomous:
        return 0.0
    natural, with_time = natural_sizes(system, [(t, x)], sizes, span)
    rows = zip(sizes, natural, with_time, strict=True)
    return max(TIME_SAFETY * ROUND_OFF * (b - a) / (s or b or 1.0) for s, a, b in rows)
