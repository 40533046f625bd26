"""From a rebuilt notebook to points and comments, for both routes of grading."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from newton_euler.algebra.language import _, spoken

from ..assignment.cells import kind, nbgrader_metadata
from ..course import CourseError
from ..sandbox import CAGED
from ..sandbox.receipts import Outcome
from ..scoring import NO_ANSWER, Score, ScoreError, score_receipt
from .execute import RunResults
from .rebuild import Work
from .sheet import Sheet

MARK = {"right": "✓", "wrong": "✗", "unreadable": "?", "blank": "–"}


@dataclass
class NotebookGrade:
    """The grade of one notebook: the scores by problem, and for each of nbgrader's cells the
    automatic points and comment; None for points that a person gives.
    """

    scores: dict[str, Score] = field(default_factory=dict)
    points: dict[str, float | None] = field(default_factory=dict)
    comments: dict[str, str | None] = field(default_factory=dict)
    note: str = ""
    sandbox: str = CAGED


def grade_notebook(
    sheet: Sheet, work: Work, executed: RunResults, kept: Mapping[str, Score]
) -> NotebookGrade:
    """Grade a notebook from the results of its run: no student code runs here. Problems in ``kept``
    need not be scored again.
    """
    notes = [work.note, executed.note]
    if executed.sandbox != CAGED:
        notes.append(executed.sandbox)
    graded = NotebookGrade(note="; ".join(n for n in notes if n), sandbox=executed.sandbox)
    by_grade_id = {}
    for number, task in sheet.tasks.items():
        score = kept.get(number) or _scored(sheet, task, work, executed)
        graded.scores[number] = by_grade_id[task.grade_id] = score
    for cell in sheet.released.notebook["cells"]:
        marks, what = nbgrader_metadata(cell), kind(cell)
        name = marks.get("grade_id", "")
        score, untouched = by_grade_id.get(name), name in work.untouched
        if marks.get("grade") and score:
            graded.points[name] = score.points
        elif marks.get("grade") and what == "test":
            graded.points[name] = points_of_test(executed.tests.get(name), marks["points"])
        elif marks.get("grade"):  # None where a person gives them
            graded.points[name] = 0.0 if what == "receipt" or untouched else None
        if marks.get("solution") or what == "task":
            empty = _("No response.") if untouched and what != "task" else None
            graded.comments[name] = feedback_comment(score) if score else empty
    return graded


def _scored(sheet, task, work, executed):
    number = task.problem
    try:
        score = score_receipt(
            task.exercise, sheet.values[number], executed.receipts.get(number),
            work.notes.get(number, ""), task.points, task.weights, task.forms, task.follow_through,
            sheet.earlier.get(number, ()),
        )  # fmt: skip
    except ScoreError as error:
        raise CourseError(str(error)) from error
    return score.without_reasons if task.help == "none" else score


def points_of_test(outcome: Outcome | None, most: float) -> float:
    """The points of an instructor's test by nbgrader's rule: none after an error, those that its
    last expression gives if that is a number, else all; clipped to 0 … ``most``.
    """
    if outcome is None or outcome["error"] is not None:
        return 0.0
    value = outcome["value"]
    if not isinstance(value, int | float):
        return float(most)
    return min(max(float(value), 0.0), float(most))


def feedback_comment(score: Score) -> str:
    """The feedback on one problem as Markdown, for nbgrader's automatic comment."""
    if all(part.message == spoken(NO_ANSWER) for part in score.parts) and not score.note:
        return _("No answer.")
    lines = [f"- {MARK[part.verdict]} `{part.key}`: {part.message}" for part in score.parts]
    return "\n".join([*([_("Note: {note}", note=score.note), ""] if score.note else []), *lines])
