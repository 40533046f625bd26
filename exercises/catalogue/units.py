"""Units and axes of answers: from base units in the code to those of the text."""

import re
from collections.abc import Iterable, Mapping
from typing import Any

from newton_euler.algebra.scalars import ZERO, is_expression, probe, scalar
from newton_euler.algebra.units import SI, US, System, unit
from newton_euler.algebra.vectors import Vector
from newton_euler.answers.forms import Form
from newton_euler.kinematics import Frame

_US = {"ft", "in", "mi", "slug", "lb", "oz"}
_METRIC = {"m", "mm", "cm", "km", "g", "kg", "N", "kN", "J", "W", "Pa"}


def system_of(symbols: Mapping[str, Any], units: Iterable[str]) -> System:
    """The coherent system of a problem's units; with feet, a formula must not contain 0.3048."""
    names = {name for text in units for name in re.findall(r"[A-Za-z]+", text)}
    return US if symbols and names & _US and not names & _METRIC else SI


def in_unit(value: Any, form: Form, system: System = SI) -> Any:
    """A result in base units of the ``system``, in the unit of its ``form``; a Vector keeps its
    terms. Words and counts, or functions that return them, are left as they are. An expression that
    vanishes identically is 0.
    """
    if form.kind.is_word:
        return value
    if isinstance(value, (tuple, list)):
        return tuple(in_unit(v, form, system) for v in value)
    if isinstance(value, Vector):
        return unit(form.unit).from_base(value.cleared(), system)
    value = scalar(value)
    if value is ZERO or (is_expression(value) and probe(value) == 0):
        return 0
    return unit(form.unit).from_base(value, system)


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


def lineage(frame: Frame) -> list[tuple[int, str]]:
    """The frames from the ground to ``frame``, by which those of two calls are compared: each by
    how many were made before it in its parent, and by its name.
    """
    return [*(lineage(frame.parent) if frame.parent else []), (frame.number, frame.name)]
