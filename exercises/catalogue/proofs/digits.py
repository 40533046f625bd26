"""The precision of proofs, and weighted sums of numbers, vectors or matrices."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeAlias

DIGITS = 50
Number: TypeAlias = Any  # an mpf or anything that mpmath converts
Triple: TypeAlias = list[Number]
Matrix: TypeAlias = list[Triple]  # rows
Place: TypeAlias = Sequence[Number]  # three coordinates
Coordinate: TypeAlias = Callable[[Number], Number]  # over time
Path: TypeAlias = Callable[[Number], Triple]  # the place of a point over time
Force: TypeAlias = Callable[[Place], Triple]  # at a place
Orientation: TypeAlias = Callable[[Number], Matrix]  # a body's, over time
Value: TypeAlias = Any  # a Number, a Triple or a Matrix
Points: TypeAlias = list[tuple[Number, Triple]]  # (share of the mass, place)
Motion: TypeAlias = Callable[[Number], Points]


class ProofError(ValueError):
    """No result: an integral that does not converge, a root that is not bracketed."""


def weighted(weights: Iterable[Number], values: Sequence[Value]) -> Value:
    """The sum of ``weights`` times ``values``, which are numbers, vectors or matrices (lists)."""
    if isinstance(values[0], (list, tuple)):
        return [weighted(weights, parts) for parts in zip(*values, strict=True)]
    return sum(w * v for w, v in zip(weights, values, strict=True))


def entries(value: Value) -> list[Number]:
    """The entries of a number, vector or matrix, as a flat list."""
    if isinstance(value, (list, tuple)):
        return [x for part in value for x in entries(part)]
    return [value]
