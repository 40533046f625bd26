"""Units and axes of answers: from base units in the code to those of the text."""

import re
from collections.abc import Iterable, Mapping
from typing import Any, Protocol

from newton_euler.algebra.scalars import ZERO, is_expression, probe, scalar
from newton_euler.algebra.units import SI, US, System, unit
from newton_euler.algebra.vectors import Vector
from newton_euler.answers.kinds import Kind
from newton_euler.kinematics import Frame


class HasUnit(Protocol):
    """Anything with a kind and a unit."""

    @property
    def kind(self) -> Kind: ...

    @property
    def unit(self) -> str: ...


_US = {"ft", "in", "mi", "slug", "lb", "oz"}
_METRIC = {"m", "mm", "cm", "km", "g", "kg", "N", "kN", "J", "W", "Pa"}


def system_of(symbols: Mapping[str, Any], units: Iterable[str]) -> System:
    """The coherent system of a problem with these units: a formula in feet and pounds must not
    contain 0.3048.
    """
    names = {name for text in units for name in re.findall(r"[A-Za-z]+", text)}
    return US if symbols and names & _US and not names & _METRIC else SI


def in_unit(value: Any, answer: HasUnit, system: System = SI) -> Any:
    """A result in base units of the ``system``, in the unit of its ``answer``; a Vector keeps its
    terms. Words and counts, or functions that return them, are left as they are. An expression that
    vanishes identically is 0.
    """
    if answer.kind.is_word:
        return value
    if isinstance(value, (tuple, list)):
        return tuple(in_unit(v, answer, system) for v in value)
    if isinstance(value, Vector):
        return unit(answer.unit).from_base(value.cleared(), system)
    value = scalar(value)
    if value is ZERO or (is_expression(value) and probe(value) == 0):
        return 0
    return unit(answer.unit).from_base(value, system)


def in_frame(frame: Frame, answers: Any) -> Any:
    """The answers, also nested by mistake, with every Vector expressed in ``frame``. One that comes
    from another call of the problem's code, with frames of its own, is in its own such frame.
    """
    if isinstance(answers, dict):
        return {name: in_frame(frame, answer) for name, answer in answers.items()}
    if not isinstance(answers, Vector):
        return answers
    if frame not in answers.frame.tree and lineage(frame) == lineage(answers.frame):
        return answers
    return answers.expressed_in(frame)


def lineage(frame: Frame) -> list[str]:
    """The names from the ground to ``frame``: by these the frames of two calls are compared, each
    of which makes its own.
    """
    return [*(lineage(frame.parent) if frame.parent else []), frame.name]
