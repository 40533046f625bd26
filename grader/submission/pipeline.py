"""The steps from one submitted notebook to points, comments and an annotated notebook, shared by
``python -m grader grade`` and ``nbgrader autograde``.
"""

import html
from dataclasses import dataclass, field
from functools import cached_property

from exercises.catalogue import CatalogueError, problem
from newton_euler.answers.notation import is_word

from ..assignment.released import (
    master_notebook,
    released_notebooks,
    released_tasks,
    sheet_numbers,
)
from ..assignment.sheet import kind, nbgrader_metadata, own_metadata
from ..course import CourseError
from ..scoring import NO_ANSWER, ScoreError, score_receipt
from .execute import cells_to_run, run_cells
from .mathml import mathml, unit_html

NOTE = "note-of-grading"  # the id of a cell that is added
MARK = {"right": "✓", "wrong": "✗", "unreadable": "?", "blank": "–"}


@dataclass(frozen=True)
class Sheet:
    """One notebook of a student's assignment, from the course alone.

    released : the notebook as it was generated for release; values : the student's numbers for its
        problems; sources : {grade id: (text, checksum)} of its cells in the gradebook, with the
        hidden tests that the released notebook lacks
    """

    course: object
    assignment: str
    student: str
    name: str
    released: dict
    values: dict
    sources: dict

    @cached_property
    def master(self):
        """The trusted notebook with the student's numbers and figures."""
        return master_notebook(self.course, self.assignment, self.student, self.name, self.values)

    @cached_property
    def tasks(self):
        """The problems that it asks for: {problem id: :class:`~grader.assignment.sheet.Task`}."""
        return released_tasks(self.course, self.assignment)[self.name]


def student_sheet(course, assignment, student, name, sources):
    """The :class:`Sheet` of a student."""
    released = released_notebooks(course, assignment)[name]
    asked = released_tasks(course, assignment)[name]
    values = sheet_numbers(course, assignment, student) if asked else {}
    return Sheet(course, assignment, student, name, released, values, sources)


@dataclass
class Graded:
    """What is given for one notebook: {problem id: :class:`~grader.scoring.Score`}, and for each
    cell of nbgrader's the automatic points and comment; None for points that a person gives.
    """

    scores: dict = field(default_factory=dict)
    points: dict = field(default_factory=dict)
    comments: dict = field(default_factory=dict)
    note: str = ""
    sandbox: str = "namespaces"


def execute(harvester, sheet, notebook):
    """Run the work in a rebuilt notebook; returns :class:`~grader.submission.execute.Executed`."""
    return run_cells(harvester, cells_to_run(sheet, notebook))


def grade_notebook(sheet, work, executed, kept=()):
    """The :class:`Graded` of a notebook, from what came out of the sandbox: no code of a student
    runs here.

    kept : {problem id: :class:`~grader.scoring.Score`} of those that need not be scored again
    """
    notes = [work.note, executed.note]
    if executed.sandbox != "namespaces":
        notes.append(executed.sandbox)
    graded = Graded(note="; ".join(n for n in notes if n), sandbox=executed.sandbox)
    by_grade_id = {}
    for number, task in sheet.tasks.items():
        score = kept[number] if number in kept else _scored(sheet, task, work, executed)
        graded.scores[number] = by_grade_id[task.grade_id] = score
    for cell in sheet.released["cells"]:
        marks, what = nbgrader_metadata(cell), kind(cell)
        name = marks.get("grade_id")
        score, untouched = by_grade_id.get(name), name in work.untouched
        if marks.get("grade"):
            graded.points[name] = _automatic_points(
                what, marks, score, untouched, executed.tests.get(name)
            )
        if marks.get("solution") or what == "task":
            said = "No response." if untouched and what != "task" else None
            graded.comments[name] = feedback_comment(score) if score else said
    return graded


def _scored(sheet, task, work, executed):
    number = task.problem
    try:
        return score_receipt(
            task.exercise, sheet.values[number], executed.receipts.get(number),
            work.notes.get(number, ""), task.points, task.weights, task.forms, task.follow_through,
        )  # fmt: skip
    except ScoreError as error:
        raise CourseError(str(error)) from error


def _automatic_points(what, marks, score, untouched, outcome):
    """The points of a graded cell, None if a person gives them."""
    if score:
        return score.points
    if what == "test":
        return points_of_test(outcome, marks["points"])
    return 0.0 if what == "receipt" or untouched else None


def _grade_id(cell):
    return nbgrader_metadata(cell).get("grade_id")


def points_of_test(outcome, most):
    """The points of an instructor's test by nbgrader's rule: none after an error, those that its
    last expression gives if that is a number, else all. A number outside of 0 to ``most`` gives the
    nearer of both.
    """
    if outcome is None or outcome["error"] is not None:
        return 0.0
    value = outcome["value"]
    if not isinstance(value, int | float):
        return float(most)
    return min(max(float(value), 0.0), float(most))


def feedback_comment(score):
    """The feedback on one problem as Markdown, for nbgrader's automatic comment."""
    if all(part.message == NO_ANSWER for part in score.parts) and not score.note:
        return "No answer."
    lines = [f"- {MARK[part.verdict]} `{part.key}`: {part.message}" for part in score.parts]
    return "\n".join([*([f"Note: {score.note}", ""] if score.note else []), *lines])


def annotate(notebook, graded, sources, earlier=""):
    """The rebuilt notebook, or one annotated before with the note ``earlier``, as nbgrader's
    autograde leaves it for those who grade by hand: with the verdicts as output of the receipt
    cells, a note above the introduction, and the instructor's texts as the gradebook has them.
    """
    cells, note = [], graded.note
    for cell in notebook["cells"]:
        own, name = own_metadata(cell), _grade_id(cell)
        if name in sources:
            cell = _as_in_gradebook(cell, *sources[name])
        if own.get("role") == "receipt" and own["problem"] in graded.scores:
            cell = {**cell, "outputs": [_output(graded.scores[own["problem"]])]}
        elif own.get("role") == "introduction":
            text = cell["source"].removeprefix(_noted(earlier))
            cell, note = {**cell, "source": _noted(note) + text}, ""
        if cell.get("id") != NOTE:
            cells.append(cell)
    if note:  # an instructor deleted the introduction
        text = _noted(note).strip()
        cells.insert(0, {"cell_type": "markdown", "id": NOTE, "metadata": {}, "source": text})
    return {**notebook, "cells": cells}


def _noted(note):
    return f"> {note}\n\n" if note else ""


def _as_in_gradebook(cell, text, checksum):
    marks = {**nbgrader_metadata(cell), "checksum": checksum}
    cell = {**cell, "metadata": {**cell["metadata"], "nbgrader": marks}}
    if marks.get("locked") and not marks.get("solution"):
        cell["source"] = text
    return cell


def _asked(number):
    """{key: (symbol, unit)} of what a problem asks for; empty where it is there no more."""
    try:
        p = problem(number)
    except CatalogueError:
        return {}
    return {a.key: (p.notation[a.key], a.unit) for a in p.answers}


def _name(key, asked):
    """The name of an answer in the student's code, and its symbol where that looks different."""
    symbol = "" if is_word(key) or key not in asked else f"{mathml(asked[key][0])} "
    return f"{symbol}<code>{html.escape(key)}</code>"


def _value(part, asked):
    if part.latex:
        return mathml(part.latex)
    return unit_html(part.read, asked.get(part.key, ("", "1"))[1])


def _output(score):
    """The verdicts as the output of a receipt cell: a table whose headers a screen reader finds, in
    which whatever a student wrote is text.
    """
    head = "".join(f'<th scope="col">{h}</th>' for h in ("part", "value read", "points", "verdict"))
    asked = _asked(score.problem)
    rows = "".join(
        f'<tr><th scope="row">{_name(p.key, asked)}</th><td>{_value(p, asked)}</td>'
        f"<td>{p.points:g} / {p.out_of:g}</td><td>{MARK[p.verdict]} {html.escape(p.message)}</td>"
        "</tr>"
        for p in score.parts
    )
    note = f"<p>{html.escape(score.note)}</p>" if score.note else ""
    text = "\n".join(
        f"{MARK[p.verdict]} {p.key}: {p.points:g} / {p.out_of:g}  {p.message}" for p in score.parts
    )
    return {
        "output_type": "display_data",
        "metadata": {},
        "data": {
            "text/plain": f"{score.note}\n{text}".strip(),
            "text/html": f"{note}<table><caption>Problem {score.problem}</caption>"
            f"<thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>",
        },
    }
