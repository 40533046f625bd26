"""Computes the points of a receipt: pure functions over data.

``score_receipt(problem, values, receipt)`` compares numbers with the key that the engine computes
for the same values, and formulas at seeded points of their domain. Nothing that a student wrote is
run, evaluated as code or simplified here.
"""

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from exercises.catalogue import Problem
from newton_euler.algebra.language import Words, _, relayed
from newton_euler.answers.causes import Cause
from newton_euler.answers.messages import one_line
from newton_euler.answers.notation import formula, unit_symbol
from newton_euler.answers.trees import NODES
from newton_euler.answers.verdicts import explain, judge, value_line

from .numbers import numbers_of
from .sheet import asked_parts

TOO_LONG = Words(  # the sentence of the cage
    "TimeLimit: the cell ran longer than {n} s; look for a loop that does not end, or a simplify "
    "of a long formula"
)


@dataclass(frozen=True)
class Part:
    """The score of one answer: ``verdict`` is right, wrong, unreadable or blank; ``message`` is for
    the student and never contains the key; ``causes`` explain a wrong answer, and ``diagnosis`` is
    the explanation in words; ``read`` is the student's own value as it was read, ``latex`` the same
    typeset where it is a formula.
    """

    key: str
    points: float
    out_of: float
    verdict: str
    message: str
    diagnosis: str | None = None
    read: str = ""
    latex: str = ""
    causes: tuple[Cause, ...] = ()

    @classmethod
    def from_dict(cls, kept: Mapping[str, Any]) -> "Part":
        """A part from what :meth:`Score.as_dict` makes of it."""
        causes = tuple(Cause(*cause) for cause in kept.get("causes", ()))
        return cls(**{**kept, "causes": causes})

    def as_dict(self) -> dict[str, Any]:
        """The part as a dict that JSON can hold."""
        return {
            **vars(self),
            "causes": [[c.group, c.name, c.text, c.where, c.subject] for c in self.causes],
        }


@dataclass(frozen=True)
class Score:
    """The score of one problem: its parts, and a note on the cell as a whole (an error in it, a
    copy of it, a missing cell).
    """

    problem: str
    parts: tuple[Part, ...]
    note: str = ""

    @property
    def points(self) -> float:
        """The sum of the points of the parts."""
        return _sum(p.points for p in self.parts)

    @property
    def out_of(self) -> float:
        """The points of all parts together."""
        return _sum(p.out_of for p in self.parts)

    @property
    def without_reasons(self) -> "Score":
        """The same score without the reasons why answers are wrong."""
        parts = (
            replace(p, message=_("not right")) if p.verdict == "wrong" else p for p in self.parts
        )
        return replace(self, parts=tuple(parts))

    def as_dict(self) -> dict[str, Any]:
        """The score as a dict that JSON can hold."""
        parts = [part.as_dict() for part in self.parts]
        sums = {"points": self.points, "out_of": self.out_of}
        return {**sums, **vars(self), "parts": parts}

    def json(self) -> str:
        """The score as JSON text."""
        return json.dumps(self.as_dict())


def _sum(shares):
    """The sum, rounded so that three thirds are 1: nbgrader refuses points above the maximum."""
    return round(math.fsum(shares), 9)


def score_receipt(
    problem: Problem,
    values: Mapping[str, Any],
    receipt: Any,
    note: str = "",
    points: float | None = None,
    weights: Mapping[str, float] | None = None,
    asked: Mapping[str, str] | None = None,
    follow_through: float | None = None,
    earlier_sheets: Sequence[Mapping[str, Any]] = (),
) -> Score:
    """The :class:`Score` of a receipt ({"answers", "faults", "error"}, or None) for ``problem``
    with a student's ``values``.

    A receipt comes from a student's process: anything that JSON can hold is accepted, and what
    cannot be read gets no points.

    points, weights, asked, follow_through : what the sheet is worth and asked for, as in
        :func:`~grader.scoring.sheet.asked_parts`
    earlier_sheets : the values of sheets that the student had before
    """
    receipt = receipt if isinstance(receipt, dict) else {}
    answers = receipt.get("answers") if isinstance(receipt.get("answers"), dict) else {}
    faults = receipt.get("faults") if isinstance(receipt.get("faults"), dict) else {}
    error = receipt.get("error")
    stopped = _("the cell stopped with {error}", error=relayed(one_line(error))) if error else ""
    sheet = asked_parts(problem, points, weights, asked, follow_through)
    numbers, budget = numbers_of(problem, values, earlier_sheets), [NODES]
    found = {}
    for part in sheet:
        key = part.answer.key
        tree, fault = answers.get(key), faults.get(key)
        found[key] = judge(part.answer, part.form, tree, fault, numbers, budget, part.factor)
    parts = tuple(_part(part, found, numbers, answers, problem.notation) for part in sheet)
    return Score(problem.id, parts, "; ".join(filter(None, (note, stopped))))


def _typeset(form, tree, shown, notation):
    """A formula that was read, in LaTeX with its unit; "" for numbers and for a very long one."""
    is_short = form.kind.is_formula and 0 < len(shown) < 200
    return formula(tree, notation) + unit_symbol(form.unit) if is_short else ""


def _part(part, found, numbers, answers, notation):
    """The score of one answer; ``found``: the verdict on each answer of the problem."""
    key, out_of = part.answer.key, part.out_of
    own, tree = found[key], answers.get(key)
    value = value_line(part.form, tree, own.verdict)
    latex = _typeset(part.form, tree, value, notation)
    if own.verdict != "wrong" or own.given is None:
        earned = out_of if own.verdict == "right" else 0
        return Part(key, earned, out_of, own.verdict, own.message, read=value, latex=latex)
    why = explain(part.answer, found, numbers)
    earned = part.following if why.earlier else 0
    share = {"earned": f"{earned:.3g}", "all": f"{out_of:.3g}"}
    earns = _(", which earns {earned} of {all}", **share) if earned else ""
    message = why.message + earns + why.also
    return Part(key, earned, out_of, "wrong", message, why.diagnosis, value, latex, why.causes)
