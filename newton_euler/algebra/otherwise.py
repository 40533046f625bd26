"""Systems built otherwise than their code says: what a student sets up wrongly, for all that is
computed from it.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

Change = Callable[[str, tuple[Any, ...], Sequence[Any]], tuple[Any, ...]]

_change: ContextVar[Change | None] = ContextVar("change", default=None)


@contextmanager
def built_otherwise(change: Change) -> Iterator[None]:
    """In the ``with`` block every point, vector, rate, turn, and every transfer and matrix of an
    inertia is built of what ``change(kind, parts, of)`` returns in place of its ``parts``.

    kind : "point" or "vector", whose parts are the components; "turn", with its axis and angle;
        "transfer", with the factor of the parallel-axis terms, which is 1; "matrix", with the nine
        entries of an inertia; "rate", with the components of the rate of a vector in its frame, or
        of an angular acceleration, or of the velocity of a point; "dot", with a scalar product;
        "motion", with those of the acceleration of a point;
        "body", with its mass, products and moments of inertia;
        "coordinate", with the distance of a point in polar coordinates; "chain", with the rates of
        what a function is of, and the two derivatives of the function
    of : what the parts belong to: of a transfer the mass, the way and the moments of inertia at its
        start, of a matrix the entries about the centre of mass, where it is elsewhere, of a rate
        the components of the vector, of a motion those of the velocity, of the velocity relative to
        the moving frame, of its angular velocity, and of the angular velocity of the point's own
        frame and its position there, of a chain what the function is of, of a scalar product the
        components of both vectors
    """
    token = _change.set(change)
    try:
        yield
    finally:
        _change.reset(token)


def built(
    kind: str, parts: tuple[Any, ...], of: Sequence[Any] | Callable[[], Sequence[Any]] = ()
) -> tuple[Any, ...]:
    """The parts of which something is built here; ``of`` may be a function that finds them."""
    change = _change.get()
    if not change:
        return parts
    if callable(of):
        token = _change.set(None)
        try:
            of = of()
        finally:
            _change.reset(token)
    return change(kind, parts, of)
