"""What a student's notebook imports: ``expect`` says what a problem asks for, ``receipt`` checks
the *form* of the answers and records them.

The form is kind, shape, finite numbers, known symbols, and for formulas the dimension. The record
is JSON: numbers, or trees of a few operators. Neither function holds or needs the key.
"""

import json
import os

from ..algebra.units import pint_name
from ..algebra.vectors import Vector
from .forms import SHAPES, AnswerError, Form, clipped, read_number
from .formula_trees import NODES, dimension_hints, in_words, read_formula

_expected, receipts = {}, {}


def expect(problem, symbols=None, **forms):
    """Announce what ``problem`` asks for: ``expect("4/16", v_D="vector, mm/s")``; ``symbols`` maps
    the symbols of formulas to their units.
    """
    _expected[problem] = (
        {key: Form.read(text) for key, text in forms.items()},
        dict(symbols or {}),
    )


def receipt(problem, **answers):
    """A :class:`Receipt` that says what was read of each answer to ``problem``, and is kept as one
    JSON record; None is an open answer.

    Raises :class:`AnswerError`, which names every answer that cannot be read.

    >>> expect("0/1", v="vector, mm/s")
    >>> receipt("0/1", v=[1, 2.5, 0])
    0/1: v = [1, 2.5, 0] mm/s. Form checked only; the key is not here.
    """
    if problem not in _expected:
        raise AnswerError(
            f"nothing is known of problem {problem!r}; run the cells of the notebook from the "
            "top, and use the numbers written there"
        )
    forms, symbols = _expected[problem]
    unknown = [key for key in answers if key not in forms]
    if unknown:
        raise AnswerError(
            f"problem {problem} does not ask for {unknown[0]!r}; it asks for {', '.join(forms)}"
        )
    read, faults = record(forms, symbols, answers)
    receipts[problem] = {"problem": problem, "answers": read, "faults": faults}
    if faults:
        raise AnswerError("\n".join(f"{problem}, {key}: {fault}" for key, fault in faults.items()))
    if os.environ.get("NBGRADER_EXECUTION") == "autograde":
        raise AnswerError(
            f"{problem} is not graded here: nbgrader runs without this course's "
            "configuration, so every part counts 0. "
            "Instructors: grade with the course's nbgrader_config.py, or with python -m "
            "grader grade"
        )
    return Receipt(problem, read, forms, symbols)


class Receipt:
    """What was handed in for one problem; ``json`` is the record."""

    def __init__(self, problem, answers, forms, symbols):
        self.problem, self.answers, self.forms, self.symbols = problem, answers, forms, symbols

    @property
    def json(self):
        """The record that is handed in, as JSON text."""
        return json.dumps({"problem": self.problem, "answers": self.answers})

    def __repr__(self):
        given = [
            f"{key} = {in_words(tree)} {self.forms[key].unit}".removesuffix(" 1")
            for key, tree in self.answers.items()
            if tree is not None
        ]
        if not given:
            return f"{self.problem}: no answer yet."
        blank = ", ".join(key for key in self.forms if self.answers.get(key) is None)
        text = (
            f"{self.problem}: {'; '.join(given)}. Form checked only; the key is not "
            f"here.{blank and f' Still open: {blank}.'}"
        )
        return "\n".join([text, *self.hints()])

    def hints(self):
        """A sentence for each formula whose dimension does not fit the unit asked for, a list."""
        formulas = [
            (key, tree)
            for key, tree in self.answers.items()
            if tree is not None and self.forms[key].kind.endswith("expression")
        ]
        return [
            f"  look again at {key}: {hint}"
            for key, tree in formulas
            for hint in dimension_hints(tree, self.forms[key], self.symbols)
        ]


def record(forms, symbols, answers):
    """({key: tree or None}, {key: fault}) of the answers, read according to their forms."""
    read, faults = {}, {}
    for key, form in forms.items():
        try:
            value = answers.get(key)
            read[key] = None if value is None else _tree(value, form, symbols)
        except AnswerError as error:
            faults[key] = str(error)
        # objects of any library may fail in any way; the student is told, the rest goes on
        except Exception as error:
            faults[key] = str(
                form.error(f"the value given cannot be read: {type(error).__name__}: {error}")
            )[:500]
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
    formula = form.kind.endswith("expression")
    read = [
        read_formula(x, form, symbols, [NODES]) if formula else read_number(x, form) for x in parts
    ]
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
    if isinstance(value, dict | set):
        raise form.error(f"got a {type(value).__name__}, which has no order")
    if getattr(value, "shape", None) == ():
        return [value]
    if hasattr(value, "__iter__") or hasattr(value, "shape"):
        return [x for part in value for x in _flat(part, form)]
    return [value]
