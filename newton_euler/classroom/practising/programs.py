"""How later quantities follow from earlier ones, as data: operations on floats, not code."""

import math
import operator
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from ...algebra.scalars import FUNCTIONS, function

_BETWEEN: dict[str, Any] = {
    "+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv,
    "**": operator.pow, "pow": operator.pow, "neg": operator.neg, "abs": abs,
    "pi": lambda: math.pi, "value": float,
    "lt": operator.lt, "le": operator.le, "gt": operator.gt, "ge": operator.ge,
    "where": lambda condition, a, b: a if condition else b,
}  # fmt: skip
OPERATIONS = {*_BETWEEN, *FUNCTIONS, "atan2"}


def operate(name: str, *numbers: Any) -> float:
    """The result of one operation, a float; of floats, since a power of whole numbers has more
    digits than fit.

    >>> operate("*", 3.0, 4.0)
    12.0
    """
    run = _BETWEEN.get(name) or partial(function, name)
    return float(run(*map(float, numbers)))


class Program:
    """The operations of one set of numbers, as a practice file has them."""

    def __init__(self, data: Mapping[str, Any] | None):
        data = data or {"operations": [], "quantities": {}, "earlier": {}}
        self._operations, self._where = data["operations"], data["quantities"]
        self.earlier = data["earlier"]

    def following(self, key: str, own: Mapping[str, Sequence[float]]) -> tuple[float, ...] | None:
        """The numbers of ``key`` by a student's ``own``, {key: numbers}; None if none."""
        places = self._where.get(key)
        if not places or None in places:
            return None
        replaced: dict[int, float] = {}
        for name, numbers in own.items():
            for place, x in zip(self._where.get(name, ()), numbers, strict=False):
                if isinstance(place, list):
                    replaced.setdefault(place[0], x / place[1])
        results: list[float] = []
        try:
            for n, (name, *arguments) in enumerate(self._operations):
                taken = (results[a[0]] if isinstance(a, list) else a for a in arguments)
                results.append(replaced[n] if n in replaced else operate(name, *taken))
        except (ArithmeticError, ValueError, TypeError):
            return None
        return tuple(x[1] * results[x[0]] if isinstance(x, list) else x for x in places)
