"""The functions ``expect`` and ``receipt`` of a student's notebook: what a problem asks for, and a
check and a record of the *form* of the answers.

The form is kind, shape, finite numbers, known symbols, and for formulas the dimension. The record
is JSON: numbers, or trees of a few operators. Neither function holds or needs the key.
"""

import json
import os
from dataclasses import dataclass

from ..algebra.errors import checked
from ..algebra.units import pint_name
from ..algebra.vectors import Vector
from .forms import SHAPES, AnswerError, Form, clipped, read_number
from .formula_trees import NODES, dimension_hints, in_words, read_formula

_expected: dict = {}
receipts: dict = {}


@checked
def expect(problem: str, symbols: dict | None = None, **forms: str) -> None:
    """Announce what ``problem`` asks for, each answer by its form.

    symbols : maps the symbols of formulas to their units

    >>> expect("0/1", v="vector, mm/s")
    >>> expect("0/2", {"r": "m", "omega": "rad/s"}, v="expression, m/s")
    """
    read = {key: Form.read(text) for key, text in forms.items()}
    _expected[problem] = read, dict(symbols or {})


@checked
def receipt(problem: str, **answers: object) -> "Receipt":
    """A :class:`Receipt` that shows how each answer to ``problem`` was read. The answers are kept
    as one JSON record; None stands for an answer that is not given yet.

    Raises :class:`AnswerError`, which names every answer that cannot be read.

    >>> expect("0/1", v="vector, mm/s")
    >>> receipt("0/1", v=[1, 2.5, 0])
    0/1: v = [1, 2.5, 0] mm/s. Form checked only; the key is not here.
    """
    if problem not in _expected:
        raise AnswerError(
            f"nothing is known of problem {problem!r}; run the cells of the notebook from the top"
        )
    forms, symbols = _expected[problem]
    for key in answers:
        if key not in forms:
            asked = ", ".join(forms)
            raise AnswerError(f"problem {problem} does not ask for {key!r}; it asks for {asked}")
    read, faults = record(forms, symbols, answers)
    receipts[problem] = {"problem": problem, "answers": read, "faults": faults}
    if faults:
        raise AnswerError("\n".join(f"{problem}, {key}: {fault}" for key, fault in faults.items()))
    if os.environ.get("NBGRADER_EXECUTION") == "autograde":
        raise AnswerError(
            f"{problem} is not graded here, since nbgrader runs without this course's "
            "configuration; use its nbgrader_config.py, or python -m grader grade"
        )
    return Receipt(problem, read, forms, symbols)


@dataclass(frozen=True, repr=False)
class Receipt:
    """The answers to one problem as they were read; ``json`` is the record."""

    problem: str
    answers: dict
    forms: dict
    symbols: dict

    @property
    def json(self):
        """The record that is handed in, as JSON text."""
        return json.dumps({"problem": self.problem, "answers": self.answers})

    def __repr__(self):
        given = {key: tree for key, tree in self.answers.items() if tree is not None}
        if not given:
            return f"{self.problem}: no answer yet."
        parts, hints = [], []
        for key, tree in given.items():
            form = self.forms[key]
            parts.append(f"{key} = {in_words(tree)} {form.unit}".removesuffix(" 1"))
            if form.is_formula:
                found = dimension_hints(tree, form, self.symbols)
                hints += [f"\n  look again at {key}: {hint}" for hint in found]
        blank = ", ".join(key for key in self.forms if key not in given)
        return (
            f"{self.problem}: {'; '.join(parts)}. Form checked only; the key is not "
            f"here.{blank and f' Still open: {blank}.'}{''.join(hints)}"
        )


def record(forms, symbols, answers):
    """({key: tree or None}, {key: fault}) of the answers, read according to their forms."""
    read, faults = {}, {}
    for key, form in forms.items():
        value = answers.get(key)
        try:
            read[key] = None if value is None else _tree(value, form, symbols)
        except AnswerError as error:
            faults[key] = str(error)
        # objects of any library may fail in any way; the student is told, the rest goes on
        except Exception as error:
            fault = form.error(f"the value given cannot be read: {type(error).__name__}: {error}")
            faults[key] = str(fault)[:500]
    return read, faults


def _tree(value, form, symbols):
    if form.kind == "choice":
        if value not in form.of:
            raise form.error(f"got {str(value)[:80]!r}")
        return value
    if form.kind == "count":
        if isinstance(value, bool) or int(value) != value:
            raise form.error(f"got {value!r}")
        return int(value)
    parts = _flat(value, form)
    if len(parts) != SHAPES[form.kind]:
        raise form.error(f"got {len(parts)} number{'s' * (len(parts) != 1)}: {clipped(value)}")
    if form.is_formula:
        read = [read_formula(x, form, symbols, [NODES]) for x in parts]
    else:
        read = [read_number(x, form) for x in parts]
    return read[0] if len(read) == 1 else read


def _flat(value, form):
    """The numbers of a scalar, vector, matrix or sequence of any library, row by row; of a pint
    quantity in the unit that is asked for.
    """
    if hasattr(value, "magnitude") and hasattr(value, "to"):
        try:
            value = value.to(pint_name(form.unit)).magnitude
        except Exception as error:
            raise form.error(f"the quantity {value} cannot be converted: {error}") from None
    if isinstance(value, str):
        raise form.error(f"got the text {clipped(value)}; write it without quotation marks")
    if isinstance(value, Vector):
        return list(value.components())
    if isinstance(value, range) and len(value) > NODES:
        raise form.error(f"got {len(value)} numbers")
    if isinstance(value, dict | set):
        raise form.error(f"got a {type(value).__name__}, which has no order")
    # an array without dimensions has __iter__, but it cannot be iterated over
    shape = getattr(value, "shape", None)
    if shape or (shape is None and hasattr(value, "__iter__")):
        return [x for part in value for x in _flat(part, form)]
    return [value]
