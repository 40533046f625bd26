"""Systems built otherwise than their code says, as a student may set them up wrongly, for all that
is computed from them.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any

Change = Callable[[str, tuple[Any, ...], Sequence[Any]], tuple[Any, ...]]

_change: ContextVar[Change | None] = ContextVar("change", default=None)


@contextmanager
def built_otherwise(change: Change | None) -> Iterator[None]:
    """In the ``with`` block systems are built of what ``change(kind, parts, of)`` returns in place
    of their ``parts``; with None as the code says. By kind, the parts and what they are ``of``:

    "point", "vector" : the components
    "turn" : axis and angle
    "coordinate" : the distance of a point in polar coordinates
    "dot" : a scalar product; of the components of both vectors
    "rate" : the components of the rate of a vector in its frame, of an angular acceleration, or of
        the velocity of a point; of the components of the vector
    "motion" : the components of the acceleration of a point; of its velocity, its velocity relative
        to the moving frame, the angular velocity of this one and of the point's own frame, and the
        position in that
    "chain" : the rates of the argument of a function, and its two derivatives; of the argument
    "body" : mass, products and moments of inertia
    "transfer" : the factor of the parallel-axis terms, 1; of mass, way, moments of inertia at its
        start
    "matrix" : the nine entries of an inertia; of those about the centre of mass, if elsewhere
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
    if not (change := _change.get()):
        return parts
    if callable(of):
        with built_otherwise(None):
            of = of()
    return change(kind, parts, of)
