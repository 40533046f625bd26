"""The gradient of a function of place, from its slopes along slanted lines."""

from collections.abc import Callable, Sequence

from mpmath import mp, mpf

from .digits import DIGITS, Number, Triple
from .motions import rate

LINES = ((1, 2, 2), (2, 1, -2), (-1, 3, 1))  # none along an axis, not all in one plane


def gradient(f: Callable[..., Number], place: Sequence[Number]) -> Triple:
    """The gradient of ``f(x, y, z)`` at ``place``, from its slopes along three slanted lines,
    without partial derivatives.

    >>> [mp.nstr(x, 6) for x in gradient(lambda x, y, z: x**2 * y * z, [3, 2, 5])]
    ['60.0', '45.0', '18.0']
    """
    with mp.workdps(DIGITS):
        place = [mpf(x) for x in place]

        def along(line):
            return lambda t: f(*(x + t * d for x, d in zip(place, line, strict=True)))

        slopes = [rate(along(line)) for line in LINES]
        return list(mp.lu_solve(mp.matrix(LINES), mp.matrix(slopes)))
