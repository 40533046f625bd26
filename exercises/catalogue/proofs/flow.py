"""Equations of motion, integrated to 25 digits up to an event or a time.

The extrapolated midpoint rule of W. Gragg, R. Bulirsch and J. Stoer (Numer. Math. 8 (1966) 1): the
rates may be in numbers of mpmath or in floats.
"""

from collections.abc import Callable
from typing import TypeAlias

from mpmath import mp, mpf

from .digits import DIGITS, Number, ProofError, Triple

# midpoint rules of 2, 4, 6 ... steps: with mpmath (error of order 27 in the step), with floats
COLUMNS = 13, 7
Rates: TypeAlias = Callable[[Triple], Triple]
ENOUGH = 10 ** -(DIGITS // 2)  # error of a step, of the change in it and of the state
STEPS = 400
HALVINGS = 50


def until(
    rates: Rates, state: Triple, event: Callable[[Triple], Number], step: Number
) -> tuple[Number, Triple]:
    """(time, state) at which ``event(state)`` first changes its sign in the motion from ``state``;
    it may start at zero.

    rates : the time derivatives of the state, a list, as a list
    step : first step, a time in which the motion changes little. A float gives a motion in floats,
    with 12 digits
    Raises :class:`ProofError` if the sign does not change in 400 steps.

    >>> from mpmath import mp
    >>> t, (q, u) = until(lambda s: [s[1], -s[0]], [mpf(1), mpf(0)], lambda s: s[0], mpf(1))
    >>> abs(t - mp.pi / 2) < 1e-14
    True
    """
    with mp.workdps(DIGITS):
        t, before = 0 * step, event(state)
        for _ in range(STEPS):
            new, done, step = _fitted(rates, state, step)
            now = event(new)
            if before * now < 0:
                part, new = _crossing(rates, state, event, done)
                return t + part, new
            state, t, before = new, t + done, now or before
    raise ProofError(f"no event within {STEPS} steps, up to the time {t}")


def after(rates: Rates, state: Triple, time: Number) -> Triple:
    """The state after the ``time``; the rest as for :func:`until`.

    >>> x, v = after(lambda s: [s[1], -10], [mpf(0), mpf(5)], mpf(1))  # a stone thrown upward
    >>> print(mp.nstr(v, 10), abs(x) < 1e-14)
    -5.0 True
    """
    with mp.workdps(DIGITS):
        left, step = time, time
        for _ in range(STEPS):
            state, done, step = _fitted(rates, state, min(step, left, key=abs))
            left = left - done
            if left == 0:
                return state
    raise ProofError(f"{STEPS} steps do not suffice for the time {time}")


def _fitted(rates, state, step):
    """The next state, the step that led to it, and the step to try next."""
    enough = 1e-13 if isinstance(step, float) else ENOUGH
    for _ in range(HALVINGS):
        new, error = _step(rates, state, step)
        if error <= enough:
            return new, step, step * (2 if error < enough / 10**6 else 1)
        step = step / 2
    raise ProofError("no step is small enough: do the rates exist and have no corners?")


def _crossing(rates, state, event, step):
    """The part of the step up to the event, and the state there: regula falsi (Illinois rule)."""
    a, b, new = 0 * step, step, state
    fa, fb = event(state), event(_step(rates, state, b)[0])
    small = abs(step) * (1e-15 if isinstance(step, float) else mpf(10) ** -(DIGITS - 15))
    moved = abs(step)
    while fa and fb and moved > small:
        t = (a * fb - b * fa) / (fb - fa)
        new, _ = _step(rates, state, t)
        ft = event(new)
        a, fa = (b, fb) if ft * fb < 0 else (a, fa / 2)
        moved, b, fb = abs(t - b), t, ft
    return (b if fa else a), new


def _step(rates, state, step):
    """The state one step later, and its error as a share of the state and its change."""
    slope, table, floats = rates(state), [], isinstance(step, float)
    for n in range(2, 2 * COLUMNS[floats] + 1, 2):
        h = step / n
        last, now = state, _along(state, h, slope)
        for _ in range(n - 1):
            last, now = now, _along(last, 2 * h, rates(now))
        row = [[(x + y) / 2 for x, y in zip(last, _along(now, h, rates(now)), strict=True)]]
        for k, coarse in enumerate(table):
            m = 2 * (len(table) - k)  # the number of steps of the coarser rule
            row.append(
                [x + (x - y) * m * m / (n * n - m * m) for x, y in zip(row[k], coarse, strict=True)]
            )
        table = row
    best, second = table[-1], table[-2]
    sizes = [max(abs(x), abs(step * r)) for x, r in zip(best, slope, strict=True)]
    least = max(sizes) / 1000  # components that are zero up to round-off do not count
    errors = (abs(x - y) for x, y in zip(best, second, strict=True))
    return best, max(e / max(s, least) for e, s in zip(errors, sizes, strict=True)) if least else 0


def _along(state, h, slope):
    return [x + h * r for x, r in zip(state, slope, strict=True)]
