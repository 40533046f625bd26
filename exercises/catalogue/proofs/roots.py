"""The root of an equation in one unknown, at 50 digits: bracketed, or of a linear function."""

from collections.abc import Callable

from mpmath import mp, mpf

from .digits import DIGITS, Number, ProofError


def root(f: Callable[[Number], Number], low: Number, high: Number) -> Number:
    """The root of ``f`` between ``low`` and ``high``, where f has different signs.

    By regula falsi and every third time bisection. Raises :class:`ProofError` if the signs are
    equal.

    >>> print(mp.nstr(root(lambda x: mp.cos(x) - x, 0, 1), 10))
    0.7390851332
    """
    with mp.workdps(DIGITS + 10):
        a, b = mpf(low), mpf(high)
        fa, fb = f(a), f(b)
        if fa * fb > 0:
            raise ProofError(
                f"no root is bracketed: f is {mp.nstr(fa, 4)} at {mp.nstr(a, 6)} and "
                f"{mp.nstr(fb, 4)} at {mp.nstr(b, 6)}; give ends with different signs"
            )
        smallest = max(abs(a), abs(b)) * mpf(10) ** -DIGITS
        n = 0
        while fa and fb and abs(b - a) > smallest:
            t = (a + b) / 2 if n % 3 == 2 else (a * fb - b * fa) / (fb - fa)
            ft, n = f(t), n + 1
            if ft * fb < 0:
                a, fa = b, fb
            else:  # the value at the end that stays is halved (Illinois rule)
                fa = fa / 2
            b, fb = t, ft
        return a if not fa else b


def vanishing(f: Callable[[Number], Number], first: Number, second: Number) -> Number:
    """The zero of a linear ``f``, from its values at two points.

    >>> print(vanishing(lambda x: 3 * x - 12, 1, 2))
    4.0
    """
    with mp.workdps(DIGITS):
        a, b = f(mpf(first)), f(mpf(second))
        return (first * b - second * a) / (b - a)
