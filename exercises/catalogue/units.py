"""From what the code of a problem computes to what the text asks for: units and axes of answers."""

from newton_euler.algebra.scalars import ZERO, scalar
from newton_euler.algebra.units import unit
from newton_euler.algebra.vectors import Vector


def in_unit(value, answer):
    """A result in base units, in the unit of its ``answer``; a Vector stays a Vector with its
    terms.
    """
    if answer.kind in ("count", "choice"):
        return value
    if isinstance(value, (tuple, list)):
        return tuple(in_unit(v, answer) for v in value)
    if isinstance(value, Vector):
        return unit(answer.unit).from_base(value)
    value = scalar(value)
    return 0 if value is ZERO else unit(answer.unit).from_base(value)


def in_frame(frame, answers):
    """The answers, or whole mistakes of answers, with every Vector expressed in ``frame`` (or in
    the frame of that name in its own tree).
    """
    if isinstance(answers, dict):
        return {name: in_frame(frame, answer) for name, answer in answers.items()}
    if not isinstance(answers, Vector):
        return answers
    return answers if answers.frame.name == frame.name else answers.expressed_in(frame)
