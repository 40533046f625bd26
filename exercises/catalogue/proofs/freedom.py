"""Degrees of freedom: the rank of a position as a function of coordinates."""

from collections.abc import Callable, Sequence

from mpmath import mp, mpf

from .digits import DIGITS, Number
from .motions import rate

SMALL = mpf(10) ** -10  # pivots below this are zero, for rates of about 1


def freedom(position: Callable[..., Sequence[Number]], *coordinates: Number) -> int:
    """The number of independent ways in which ``position(*coordinates)``, a list of numbers, can
    change.

    >>> freedom(lambda a, b: [mp.cos(a + b), mp.sin(a + b)], mpf(1), mpf(2))
    1
    """
    with mp.workdps(DIGITS):
        rows = []
        for n in range(len(coordinates)):

            def moved(t, n=n):
                return position(*(q + t * (k == n) for k, q in enumerate(coordinates)))

            rows.append([mpf(x) for x in rate(moved)])
        return _rank(rows)


def _rank(rows):
    """The rank, by elimination with column pivots."""
    rank = 0
    for column in range(len(rows[0])):
        pivot = max(rows[rank:], key=lambda row: abs(row[column]), default=None)
        if pivot is None or abs(pivot[column]) < SMALL:
            continue
        rows.remove(pivot)
        rows.insert(rank, pivot)
        for row in rows[rank + 1 :]:
            factor = row[column] / pivot[column]
            row[:] = [x - factor * p for x, p in zip(row, pivot, strict=True)]
        rank += 1
    return rank
