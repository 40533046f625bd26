"""Words and counts: answers without a unit. The code of a problem may return functions without
arguments, which may branch: they are called with numbers.

    {"sense": lambda: "ascending" if v_y > 0 else "descending"}
"""

from collections.abc import Callable, Mapping
from contextlib import suppress
from operator import index
from typing import Any, Protocol

from newton_euler.algebra.scalars import Scalar, is_numeric


class HasSymbols(Protocol):
    """The part of a problem used here: the ranges of its symbols, and givens for its code."""

    symbols: Mapping[str, Any]

    def base(self, values: Mapping[str, Scalar], one: Scalar = 1.0) -> Any:
        """The givens for the code of the problem."""


def word(value: Any) -> Any:
    """A word or whole number, or the one that a function returns."""
    value = value() if callable(value) else value
    if isinstance(value, str):
        return str(value)
    with suppress(TypeError):
        return index(value)  # also of a :class:`~newton_euler.dynamics.constraints.Freedom`
    try:
        return int(value) if int(value) == value else value
    except (TypeError, ValueError):  # reported by the check of the problem
        return value


def words_at(
    p: HasSymbols, compute: Callable[[Any], Mapping], values: Mapping[str, Scalar], one: Scalar
) -> dict:
    """The words and counts of problem ``p`` by ``compute(g)``, {key: answer}, for ``values`` in the
    units of the text, computed on scalars, so that the code may branch.

    A symbol without a number takes the middle of its range. Arrays give an array of words.
    """
    import numpy as np

    values = {n: x if is_numeric(x) else sum(p.symbols[n].vary) / 2 for n, x in values.items()}
    shape = np.broadcast_shapes(*(getattr(x, "shape", ()) for x in values.values()))
    if not shape:
        return {k: word(x) for k, x in compute(p.base(values, one)).items()}
    rows = {n: np.broadcast_to(x, shape).reshape(-1).tolist() for n, x in values.items()}
    each = zip(*rows.values(), strict=True)
    found = [words_at(p, compute, dict(zip(rows, row, strict=True)), one) for row in each]
    return {k: np.array([x[k] for x in found], dtype=object).reshape(shape) for k in found[0]}
