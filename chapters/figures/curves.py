"""Places along a curve, and states along a motion, for figures that a browser draws without NumPy."""

from typing import Any

from newton_euler import Model, integrate


def evenly(first: float, last: float, count: int) -> list[float]:
    """So many numbers from ``first`` to ``last``, at equal distances.

    >>> evenly(0, 1, 5)
    [0.0, 0.25, 0.5, 0.75, 1.0]
    """
    return [first + (last - first) * n / (count - 1) for n in range(count)]


def states_over(model: Model, time: float, start: tuple[float, ...], count: int) -> list[tuple]:
    """So many states of a motion without events, at equal intervals from its start to ``time``.

    >>> fall = Model("fall", {"g": 10.0}, ("h", "v"), lambda s, p, t: (s.v, -p.g))
    >>> [round(h, 6) for h, v in states_over(fall, 2.0, (100.0, 0.0), 3)]
    [100.0, 95.0, 80.0]
    """
    motion: Any = integrate(model, time, start)
    state_at = motion.segments[0].stepper.state_at
    return [state_at(t) for t in evenly(0.0, time, count)]
