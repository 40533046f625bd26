"""Places along a curve, and states along a motion, for figures that a browser draws without NumPy."""

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from typing import Any

from newton_euler import Model, integrate
from newton_euler.algebra.late import mpmath
from newton_euler.algebra.scalars import Scalar, Triple
from newton_euler.kinematics.paths import Path


def evenly(first: float, last: float, count: int) -> list[float]:
    """``count`` numbers from ``first`` to ``last``, at equal distances.

    >>> evenly(0, 1, 5)
    [0.0, 0.25, 0.5, 0.75, 1.0]
    """
    return [first + (last - first) * n / (count - 1) for n in range(count)]


def parts(v: Iterable[Scalar]) -> Triple:
    """The components of a vector, or the coordinates of a place, as floats."""
    return tuple(map(float, v))


def states_over(model: Model, time: float, start: tuple[float, ...], count: int) -> list[tuple]:
    """``count`` states of a motion without events, at equal intervals from its start to ``time``.

    >>> fall = Model("fall", {"g": 10.0}, ("h", "v"), lambda s, p, t: (s.v, -p.g))
    >>> [round(h, 6) for h, v in states_over(fall, 2.0, (100.0, 0.0), 3)]
    [100.0, 95.0, 80.0]
    """
    motion: Any = integrate(model, time, start)
    state_at = motion.segments[0].stepper.state_at
    return [state_at(t) for t in evenly(0.0, time, count)]


def second_derivative(path: Path, t: float) -> list[Scalar]:
    """The second derivative of each coordinate of ``path`` at t, from 50 digits."""
    with mpmath.workdps(50):
        return [mpmath.diff(lambda s, n=n: path(s)[n], mpmath.mpf(t), 2) for n in range(3)]


def level_lines(
    height: Callable[[float, float], float], level: float, xs: Sequence[float], ys: Sequence[float]
) -> list[list[tuple[float, float]]]:
    """The lines on which ``height`` is ``level``, each a list of places: straight across the cells
    of a grid. A corner at the level counts as above it.

    >>> [circle] = level_lines(lambda x, y: x * x + y * y, 1.0, evenly(-2, 2, 9), evenly(-2, 2, 9))
    >>> circle[0] == circle[-1], all(0.9 < x * x + y * y < 1.1 for x, y in circle)
    (True, True)
    """
    z = [[height(x, y) - level for x in xs] for y in ys]
    next_to: defaultdict[Any, list[Any]] = defaultdict(list)

    def is_crossed(side):
        (n, m), (k, l) = side
        return (z[m][n] >= 0) != (z[l][k] >= 0)

    for m in range(len(ys) - 1):
        for n in range(len(xs) - 1):
            a, b, c, d = (n, m), (n + 1, m), (n + 1, m + 1), (n, m + 1)
            sides = [side for side in ((a, b), (b, c), (d, c), (a, d)) if is_crossed(side)]
            for one, other in zip(sides[::2], sides[1::2], strict=True):
                next_to[one].append(other)
                next_to[other].append(one)

    def place(side):
        (n, m), (k, l) = side
        part = z[m][n] / (z[m][n] - z[l][k])
        return xs[n] + part * (xs[k] - xs[n]), ys[m] + part * (ys[l] - ys[m])

    return [[place(side) for side in line] for line in _walks(next_to)]


def _walks(next_to):
    """Every connection once, in walks from an end, or round."""
    for start in sorted(next_to, key=lambda side: len(next_to[side])):
        while next_to[start]:
            walk = [start]
            while next_to[walk[-1]]:
                side = next_to[walk[-1]].pop()
                next_to[side].remove(walk[-1])
                walk.append(side)
            yield walk
