"""Homogeneous bodies as mass points: sums over them are the integrals over the bodies.

Each body is a list of pairs (share of the mass, place), places being three numbers from the
centre of the body. The sum of share times f(place) is the mean of f over the body, exact for
polynomials of x, y, z up to the degree 2 ``order`` - 1; other functions, like the attraction of a
ball, need a larger order.

    moment = m * mean(lambda r: r[0] ** 2 + r[1] ** 2, ball(R))     2 m R^2/5
"""

from collections.abc import Callable
from functools import cache

from mpmath import mp, mpf

from .digits import DIGITS, Number, Points, Triple, Value, weighted

ORDER = 4


def mean(f: Callable[[Triple], Value], points: Points) -> Value:
    """The mean of ``f`` (number, vector, matrix) over mass points; times the mass, its integral."""
    with mp.workdps(DIGITS):
        return weighted([share for share, _ in points], [f(place) for _, place in points])


def box(a: Number, b: Number, c: Number, order: int = ORDER) -> Points:
    """A box with edges a, b, c along x, y, z: a plate if one is 0, a rod if two are."""
    with mp.workdps(DIGITS):
        along = lambda edge: _between(-mpf(edge) / 2, mpf(edge) / 2, order if edge else 1)
        xs, ys, zs = map(along, (a, b, c))
        return [(u * v * w, [x, y, z]) for u, x in xs for v, y in ys for w, z in zs]


def ring(radius: Number, order: int = ORDER) -> Points:
    """A thin ring about z, with its centre at the origin."""
    with mp.workdps(DIGITS):
        n = 2 * order
        turns = [2 * mp.pi * k / n for k in range(n)]
        return [(mpf(1) / n, [radius * mp.cos(t), radius * mp.sin(t), mpf(0)]) for t in turns]


def disk(radius: Number, order: int = ORDER) -> Points:
    """A thin disk about z: rings with mass proportional to their radius."""
    with mp.workdps(DIGITS):
        return [
            (2 * share * u * w, place)
            for share, u in _between(mpf(0), mpf(1), order + 1)
            for w, place in ring(radius * u, order)
        ]


def shell(radius: Number, order: int = ORDER) -> Points:
    """A thin hollow sphere: rings of equal mass at equal steps of height (Archimedes)."""
    with mp.workdps(DIGITS):
        return [
            (share * w, [x, y, radius * h])
            for share, h in _between(mpf(-1), mpf(1), order)
            for w, (x, y, _) in ring(radius * mp.sqrt(1 - h * h), order)
        ]


def ball(radius: Number, order: int = ORDER) -> Points:
    """A solid sphere: shells with mass proportional to the square of their radius."""
    with mp.workdps(DIGITS):
        return [
            (3 * share * u * u * w, place)
            for share, u in _between(mpf(0), mpf(1), order + 1)
            for w, place in shell(radius * u, order)
        ]


def cone(radius: Number, height: Number) -> Points:
    """A solid cone with its apex at the origin, opening along z: disks that grow from the apex."""
    with mp.workdps(DIGITS):
        base = disk(radius, order=2)
        return [
            (3 * share * u * u * w, [u * x, u * y, u * height])
            for share, u in _between(mpf(0), mpf(1), 3)
            for w, (x, y, _) in base
        ]


def raised(points: Points, length: Number) -> Points:
    """Mass points spread along z as well, symmetrically over this length."""
    with mp.workdps(DIGITS):
        return [
            (u * v, [x, y, z + up])
            for u, (x, y, z) in points
            for v, (_, _, up) in box(0, 0, length, order=2)
        ]


def along_x(points: Points) -> Points:
    """Mass points turned from the axis z to the axis x."""
    return [(share, [z, x, y]) for share, (x, y, z) in points]


def _between(low, high, n):
    """Pairs (share, abscissa) of the Gauss rule with ``n`` points; the shares sum to 1."""
    return [(w / 2, low + (high - low) * (1 + x) / 2) for w, x in _gauss(n)]


@cache
def _gauss(n):
    """Pairs (weight, abscissa) of the Gauss-Legendre rule on (-1, 1), by Newton's method."""
    with mp.workdps(DIGITS + 10):
        pairs = []
        for k in range(n):
            x = mp.cos(mp.pi * (k + mpf(3) / 4) / (n + mpf(1) / 2))
            for _ in range(8):
                before, value = mpf(1), x
                for m in range(2, n + 1):
                    before, value = value, ((2 * m - 1) * x * value - (m - 1) * before) / m
                slope = n * (before - x * value) / (1 - x * x)
                x -= value / slope
            pairs.append((2 / ((1 - x * x) * slope**2), x))
        return tuple(pairs)
