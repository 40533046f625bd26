"""Integrals of numbers, vectors and matrices over one variable, at 50 digits."""

from collections.abc import Callable, Sequence
from itertools import pairwise

from mpmath import mp, mpf

from .digits import DIGITS, Number, ProofError, Value, entries, weighted

LEVELS = 9  # levels of the rule; each halves the step
# change, relative to the integral of abs(f), at which an integral has converged
ENOUGH = 10 ** (-DIGITS * 3 // 5)


def integral(
    f: Callable[[Number], Value], start: Number, end: Number, breaks: Sequence[Number] = ()
) -> Value:
    """The integral of ``f`` (a number, vector or matrix) from ``start`` to ``end``.

    f may have infinite slopes at the ends; ``breaks``, in order, are its corners and jumps between
    them. Raises :class:`ProofError` if the integral does not converge to 30 digits.

    The tanh-sinh rule: with x = tanh(pi/2 sinh t) the integrand falls off so fast at both ends that
    equal steps of t are as good as any.

    >>> with mp.workdps(DIGITS):
    ...     abs(integral(mp.sqrt, 0, 1) - mpf(2) / 3) < mpf(10) ** -45
    True
    """
    with mp.workdps(DIGITS):
        places = [mpf(x) for x in (start, *breaks, end)]
        pieces = [_piece(f, a, b) for a, b in pairwise(places)]
        return weighted([1] * len(pieces), pieces)


def _piece(f, a, b):
    with mp.workdps(2 * DIGITS):  # so that abscissas close to an end differ from it
        a, b = +a, +b
        step, before = mpf(1), None
        weights, values = _samples(f, a, b, 0, step)
        for _ in range(LEVELS):
            step /= 2
            more = _samples(f, a, b, step, 2 * step)
            weights, values = weights + more[0], values + more[1]
            found = weighted([w * step for w in weights], values)
            if before is not None and _settled(found, before, weights, values, step):
                return found
            before = found
    raise ProofError(
        f"the integral from {mp.nstr(a, 6)} to {mp.nstr(b, 6)} does not converge: give the places "
        "of corners and jumps as breaks=(...)"
    )


def _samples(f, a, b, first, step):
    """Weights and values of f at t = ±first, ±(first + step), … until the weights vanish."""
    weights, values, t, half = [], [], first, (b - a) / 2
    while True:
        far = mp.exp(mp.pi * mp.sinh(t))
        near, weight = 1 / (1 + far), mp.pi * mp.cosh(t) * far / (1 + far) ** 2
        if near < mpf(10) ** (-1.5 * DIGITS):
            return weights, values
        for place in {a + 2 * half * near, b - 2 * half * near}:  # one abscissa at the middle
            weights.append(2 * half * weight)
            values.append(f(place))
        t += step


def _settled(found, before, weights, values, step):
    change = [abs(x - y) for x, y in zip(entries(found), entries(before), strict=True)]
    sizes = [[abs(x) for x in entries(v)] for v in values]
    scale = entries(weighted([abs(w) * step for w in weights], sizes))
    # the error is about the square of the change at a halving
    return max(change) <= ENOUGH * max(scale) if max(scale) else True
