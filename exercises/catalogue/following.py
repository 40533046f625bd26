"""Later answers of a problem from a student's own earlier ones.

The code of a problem defines ``follows``: {later answer: function of the givens and, by name, of
earlier answers}, in base units, vectors along the axes of the answers, matrices as three rows:

    follows = {"r": lambda g, speed: speed / g.n}
"""

import inspect
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from newton_euler import Frame
from newton_euler.algebra.scalars import Scalar
from newton_euler.algebra.units import unit
from newton_euler.algebra.vectors import Vector

from .model import Givens, Problem
from .units import in_unit
from .variants import flat
from .words import word


@cache
def earlier_answers(p: Problem) -> dict[str, tuple[str, ...]]:
    """{later answer: names of the earlier answers from which it follows} of problem ``p``."""
    follows = getattr(p.code, "follows", {})
    return {key: tuple(inspect.signature(f).parameters)[1:] for key, f in follows.items()}


def follow(
    p: Problem, key: str, values: Mapping[str, Scalar], earlier: Mapping[str, tuple]
) -> tuple[Any, ...]:
    """The answer ``key`` that follows from ``earlier`` answers, as a tuple of numbers or a word.

    values : givens and symbols in the units of the text
    earlier : {answer: tuple of numbers, in its unit}, of at least those in ``earlier_answers``
    """
    base = {}
    for name in earlier_answers(p)[key]:
        a, given = p.answer(name), earlier[name]
        to_base = unit(a.unit).to_base
        base[name] = given if a.kind.is_word else [to_base(x, p.system) for x in given]
    found = follow_in_base(p, key, p.base(values), base)
    if p.answer(key).kind.is_word:
        return (word(found),)
    return flat(in_unit(found, p.answer(key).form, p.system))


def follow_in_base(p: Problem, key: str, g: Givens, earlier: Mapping[str, Sequence[Any]]) -> Any:
    """:func:`follow` in base units: a scalar, a Vector, rows, or a word."""
    frame = Frame("axes of the answers")
    return p.code.follows[key](g, **{n: _nested(p, n, x, frame) for n, x in earlier.items()})


def _nested(p, name, numbers, frame):
    kind = p.answer(name).kind
    return frame.vector(*numbers) if kind.is_vector else kind.nested(numbers)


def acceleration_of(omega: Vector, alpha: Vector, r: Vector) -> Vector:
    """The acceleration of the tip of ``r`` relative to its tail, both fixed in the body."""
    return alpha.cross(r) + omega.cross(omega.cross(r))
