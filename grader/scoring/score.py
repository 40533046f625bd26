"""Computes the points of a receipt: pure functions over data.

``score_receipt(problem, values, receipt)`` compares numbers with the key that the engine computes
for the same values, and formulas at seeded points of their domain. Nothing that a student wrote is
run, evaluated as code or simplified here.
"""

import json
import math
import reprlib
from dataclasses import dataclass, replace

from exercises.catalogue.words import WORDS
from exercises.following import earlier_answers
from newton_euler.classroom.formula_trees import NODES, TreeError, in_words
from newton_euler.classroom.notation import formula, unit_symbol

from .diagnosis import BOOK, Elsewhere, causes, diagnose, observe
from .numbers import numbers_of
from .reading import read
from .sheet import asked_parts
from .slips import factors
from .tolerance import FORMULA_RTOL, RTOL, is_right

NO_ANSWER = "no answer"


@dataclass(frozen=True)
class Part:
    """The score of one answer: ``verdict`` is right, wrong, unreadable or blank; ``message`` is for
    the student and never contains the key; ``read`` is the student's own value as it was read,
    ``latex`` the same typeset where it is a formula.
    """

    key: str
    points: float
    out_of: float
    verdict: str
    message: str
    diagnosis: str | None = None
    read: str = ""
    latex: str = ""


@dataclass(frozen=True)
class Score:
    """The score of one problem: its parts, and a note on the cell as a whole (an error in it, a
    copy of it, a missing cell).
    """

    problem: str
    parts: tuple
    note: str = ""

    @property
    def points(self):
        """The sum of the points of the parts."""
        return _sum(p.points for p in self.parts)

    @property
    def out_of(self):
        """What the parts are worth together."""
        return _sum(p.out_of for p in self.parts)

    def as_dict(self):
        """The score as a dict that JSON can hold."""
        parts = [dict(vars(part)) for part in self.parts]
        sums = {"points": self.points, "out_of": self.out_of}
        return {**sums, **vars(self), "parts": parts}

    def json(self):
        """The score as JSON text."""
        return json.dumps(self.as_dict())


def _sum(shares):
    """The sum, in which three thirds are 1: nbgrader refuses points above the maximum."""
    return round(math.fsum(shares), 9)


def score_receipt(
    problem,
    values,
    receipt,
    note="",
    points=None,
    weights=None,
    asked=None,
    follow_through=None,
):
    """The :class:`Score` of a receipt ({"answers", "faults", "error"}, or None) for ``problem``
    with a student's ``values``.

    A receipt comes from a student's process: anything that JSON can hold is accepted, and what
    cannot be read gets no points.

    points, weights, asked, follow_through : what the sheet is worth and asked for, as in
        :func:`~grader.scoring.sheet.asked_parts`
    """
    receipt = receipt if isinstance(receipt, dict) else {}
    answers = receipt.get("answers") if isinstance(receipt.get("answers"), dict) else {}
    faults = receipt.get("faults") if isinstance(receipt.get("faults"), dict) else {}
    error = receipt.get("error")
    notes = [n for n in (note, f"the cell stopped with {clipped(error)}" if error else "") if n]
    sheet = asked_parts(problem, points, weights, asked, follow_through)
    numbers, budget = numbers_of(problem, values), [NODES]
    found = {part.answer.key: _judged(part, answers, faults, numbers, budget) for part in sheet}
    parts = tuple(_part(part, found, numbers, answers) for part in sheet)
    parts = tuple(
        replace(p, latex=_typeset(part, answers, p.read, problem))
        for part, p in zip(sheet, parts, strict=True)
    )
    return Score(problem.id, parts, "; ".join(notes))


def _typeset(part, answers, shown, problem):
    """A formula that was read, in LaTeX with its unit; "" for numbers and for a very long one."""
    if not shown or not part.form.is_formula or len(shown) >= 200:
        return ""
    tree = answers[part.answer.key]
    return formula(tree, problem.notation) + unit_symbol(part.form.unit)


def _shown(part, answers, found):
    """The value that was read, with its unit, as a line for the student; "" if none was."""
    key, unit = part.answer.key, part.form.unit
    if found[key].verdict not in ("right", "wrong"):
        return ""
    tree = answers[key]
    if part.answer.kind in WORDS:  # any JSON
        return clipped(tree)[:200]
    between = ", " if type(tree) is dict else " "  # components in several frames
    text = in_words(tree)[:200] + (between + unit if unit != "1" else "")
    return clipped(text) if type(tree) is dict else text  # the student named the frames


@dataclass(frozen=True)
class _Judged:
    """What an answer is: its verdict, what to say, and what was read, in the unit of the key."""

    verdict: str
    message: str
    given: tuple | None = None


def _judged(part, answers, faults, numbers, budget):
    a = part.answer
    tree, key = answers.get(a.key), numbers.key[a.key]
    if a.key in faults:
        return _Judged("unreadable", clipped(faults[a.key]))
    if tree is None:
        return _Judged("blank", NO_ANSWER)
    if a.kind in WORDS:
        ((word,),) = key
        given = ((tree,),) if type(tree) is type(word) else None
        return _Judged(*(("right", "right") if given == key else ("wrong", "not right")), given)
    try:
        readings = read(part.form, tree, numbers.symbols, budget)
    except TreeError as error:
        return _Judged("unreadable", f"cannot be read: {clipped(str(error))}")
    if part.factor != 1:
        readings = [_times(part.factor, x) for x in readings]
    for given in readings:
        if is_right(a.kind, given, key, a.atol):
            return _Judged("right", "right", given)
    return _Judged("wrong", "not right", readings[0])


def _times(factor, points):
    return tuple(tuple(factor * x for x in point) for point in points)


def _part(part, found, numbers, answers):
    """The score of one answer; ``found`` has what each answer of the problem is."""
    key, out_of, own = part.answer.key, part.out_of, found[part.answer.key]
    shown = _shown(part, answers, found)
    if own.verdict != "wrong" or own.given is None:
        earned = out_of if own.verdict == "right" else 0
        return Part(key, earned, out_of, own.verdict, own.message, read=shown)
    message, cause = _explained(part.answer, found, numbers)
    earlier = _followed(part.answer, found, numbers) if cause != BOOK else ()
    if earlier:
        message += f"; it follows from your {' and '.join(earlier)}"
        message += f", which earns {part.following:.3g} of {out_of:.3g}" if part.following else ""
        cause = cause or f"follows from a wrong {' and '.join(earlier)}"
        return Part(key, part.following, out_of, "wrong", message, cause, shown)
    if cause is None and (seen := observe(own.given, numbers.key[key], part.answer.kind)):
        message, cause = f"not right; {seen}", seen
    return Part(key, 0, out_of, "wrong", message, cause, shown)


def _explained(a, found, numbers):
    """(message, diagnosis) of a wrong answer."""
    given, key = found[a.key].given, numbers.key[a.key]
    cause = diagnose(
        given,
        key,
        _models(a, numbers),
        _rtol(a.kind),
        a.kind,
        factors(a.kind, a.unit),
        Elsewhere(lambda: _elsewhere(a, found, numbers)),
    )
    if BOOK in causes(cause):
        return "not right: this is the answer for the book's numbers; yours are others", BOOK
    if cause is None:
        return "not right", None
    return f"not right; it fits a solution that {cause}", cause


def _rtol(kind):
    return FORMULA_RTOL if kind.endswith("expression") else RTOL


def _models(a, numbers):
    """The wrong models of an answer, and its key for the book's numbers."""
    book = numbers.book.get(a.key)
    return [*numbers.wrong(a.key), ("book", BOOK, book)] if book else numbers.wrong(a.key)


def _elsewhere(a, found, numbers):
    """The other parts that a student answered, for :class:`~grader.scoring.diagnosis.Elsewhere`."""
    parts = []
    for other in numbers.problem.answers:
        judged = found.get(other.key)
        if other.key != a.key and judged and judged.given is not None:
            key, wrong = numbers.key[other.key], _models(other, numbers)
            right = judged.verdict == "right"
            parts.append((right, judged.given, key, wrong, _rtol(other.kind)))
    return parts


def _followed(a, found, numbers):
    """The student's own wrong answers from which this one follows rightly; () if it does not."""
    names = earlier_answers(numbers.problem).get(a.key, ())
    wrong = [n for n in names if n in found and found[n].verdict == "wrong"]
    # an earlier part that the sheet does not ask for is not the student's
    earlier = {n: found[n].given if n in found else numbers.key[n] for n in names}
    if not wrong or None in earlier.values():
        return ()
    expected = numbers.following(a.key, earlier)
    if a.kind in WORDS:
        return wrong if expected == found[a.key].given else ()
    if expected is None or max(math.hypot(*point) for point in expected) <= a.atol:
        return ()  # zero follows from zero: nothing was computed
    return wrong if is_right(a.kind, found[a.key].given, expected, a.atol) else ()


_bounded = reprlib.Repr()
_bounded.maxstring = _bounded.maxother = 400


def clipped(value):
    """Any value as one printable line: students control the text of error messages, which are
    written to files, tables and pages.
    """
    text = value[:4000] if isinstance(value, str) else _bounded.repr(value)
    line = " ".join(text.split())[:400]
    return "".join(c if c.isprintable() else "\ufffd" for c in line)
