"""Reads the components of an answer out of the JSON of a receipt, in a bounded time: the bounds
count operations, not seconds, to be the same on every machine. Anything but an answer raises
:class:`TreeError`.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from ..algebra.late import np
from .tolerance import ONE_VECTOR, Points
from .trees import TreeError, check_size, evaluate

_NOISE = 1e-9  # relative: an imaginary part so small is round-off
Budget = list[int]  # a list of one number: the operations that may still be read


def numbers(trees: Sequence[Any]) -> Points:
    """One point of finite floats, from ints and floats."""
    return (tuple(_finite(t) for t in trees),)


def _finite(x):
    if isinstance(x, int) and x.bit_length() > 1000:
        raise TreeError("a number is too large")
    if not math.isfinite(x):
        raise TreeError("got {x}, which is not a number", x=x)
    return float(x)


def formula_values(trees: Sequence[Any], symbols: Mapping[str, Any], budget: Budget) -> Points:
    """The values of formula trees at each of the points, ``symbols``: {name: array}."""
    for part in trees:
        check_size(part, budget)
    count = max((len(v) for v in symbols.values()), default=1)
    try:
        with np.errstate(all="ignore"):
            rows = [_values(t, symbols, count) for t in trees]
    except TreeError:
        raise
    # numbers, arrays and complex ones meet in every operation here, and each library refuses some
    # of them with errors of its own: the fault is always the formula's
    except Exception as error:
        raise TreeError("the formula has no value: {error}", error=error) from error
    return tuple(zip(*rows, strict=True))


def _values(tree, symbols, count):
    """The values of a formula, by complex numbers where it is not real, as in log(-x)^2."""
    found = _real(evaluate(tree, symbols), count)
    if not any(map(math.isnan, found)):
        return found
    wide = evaluate(tree, {n: np.asarray(x, dtype=complex) for n, x in symbols.items()})
    wide = np.broadcast_to(np.asarray(wide), (count,))
    real = np.abs(wide.imag) <= _NOISE * np.abs(wide)
    return np.where(np.isnan(found) & real, wide.real, found).tolist()


def _real(x, count):
    x = np.asarray(x)
    x = x if x.shape == (count,) else np.broadcast_to(x, (count,))
    if x.dtype.kind == "c":  # NumPy would drop the imaginary part with a warning
        if not (np.abs(x.imag) <= _NOISE * np.abs(x).max()).all():
            raise TreeError("it gives complex numbers: a root of a negative number")
        x = x.real
    return x.astype(float).tolist()


def are_one_vector(first: Points, *others: Points) -> bool:
    """True if answers have the same magnitude at each point, as a vector has in all frames."""
    sizes, *rest = [[math.hypot(*point) for point in points] for points in (first, *others)]
    pairs = (pair for other in rest for pair in zip(sizes, other, strict=True))
    return all(abs(a - b) <= ONE_VECTOR * a for a, b in pairs)
