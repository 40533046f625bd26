"""Reads an answer of a receipt as numbers. Whatever JSON holds, this takes a bounded time, and what
is no answer raises :class:`TreeError`.

The bounds count operations and not seconds, so that a receipt earns the same on every machine.
"""

import math

import numpy as np

from .forms import SHAPES
from .receipts import FRAMES
from .trees import TreeError, check_size, evaluate


def read(form, tree, symbols, budget):
    """The readings of an answer (a number, a formula tree, or a list of them), a list of answers as
    in :mod:`.tolerance`; several only of a vector that is given in several frames.

    symbols : {name: array of the points at which formulas are compared}
    budget : a list of one number, the operations that may still be read
    """
    if isinstance(tree, dict) and form.kind.startswith("vector") and 0 < len(tree) <= FRAMES:
        readings = [_read(form, part, symbols, budget) for part in tree.values()]
        if not _of_one_size(*readings):
            raise TreeError("its components in two frames are those of two vectors")
        return readings
    return [_read(form, tree, symbols, budget)]


def _of_one_size(first, *others):
    """True if answers have the same magnitude at each point, as a vector has in all frames."""
    return all(
        abs(math.hypot(*a) - math.hypot(*b)) <= 1e-6 * math.hypot(*a)
        for other in others
        for a, b in zip(first, other, strict=True)
    )


def _read(form, tree, symbols, budget):
    trees = tree if SHAPES[form.kind] > 1 else [tree]
    if not isinstance(trees, list) or len(trees) != SHAPES[form.kind]:
        raise TreeError(f"expected {form.words}")
    if form.is_formula:
        for part in trees:
            check_size(part, budget)
        return _values(trees, symbols)
    if not all(type(t) in (int, float) for t in trees):
        raise TreeError(f"expected {form.words}")
    return (tuple(_finite(t) for t in trees),)


def _finite(x):
    if isinstance(x, int) and x.bit_length() > 1000:
        raise TreeError("a number is too large")
    if not math.isfinite(x):
        raise TreeError(f"got {x}, which is no number")
    return float(x)


def _values(trees, symbols):
    count = max((len(v) for v in symbols.values()), default=1)
    try:
        with np.errstate(all="ignore"):
            rows = [_real(evaluate(t, symbols), count) for t in trees]
    except TreeError:
        raise
    # numbers, arrays and complex ones meet in every operation here, and each library refuses some
    # of them with errors of its own: the fault is always the formula's
    except Exception as error:
        raise TreeError(f"the formula has no value: {error}") from error
    return tuple(zip(*rows, strict=True))


def _real(x, count):
    x = np.broadcast_to(np.asarray(x), (count,))
    if x.dtype.kind == "c":  # NumPy would drop the imaginary part with a warning
        if not (np.abs(x.imag) <= 1e-9 * np.abs(x).max()).all():
            raise TreeError("it gives complex numbers: a root of a negative number")
        x = x.real
    return x.astype(float).tolist()
