"""The steps from a student's answers to scores and an annotated notebook, shared by
``python -m grader grade`` and ``nbgrader autograde``.
"""

import html
from dataclasses import dataclass

from ..assignment import notebook as nb
from ..assignment.personal import master_notebook
from ..course import CourseError
from ..scoring import NO_ANSWER, score_receipt
from .rebuild import is_untouched

MARK = {"right": "✓", "wrong": "✗", "unreadable": "?", "blank": "–"}


@dataclass(frozen=True)
class StudentAssignment:
    """A student's assignment: the trusted notebook, its problems and the student's numbers."""

    student: str
    master: dict
    problems: list
    values: dict


def student_assignment(course, assignment, student):
    """The :class:`StudentAssignment` of a student, from the course alone; raises
    :class:`CourseError` if the fetched copy has other numbers.
    """
    master = master_notebook(course, assignment, student)
    problems = nb.problems_of(master)
    values = course.values(assignment, student, problems)
    if differing := nb.first_differing_problem(master, values):
        raise CourseError(
            f"the copy that {student} fetched "
            f"({course.personal_path(assignment, student)}) has other numbers for "
            f"{differing} than are derived now: "
            "the exercises or the course's secret have changed since. Grade with the "
            "version and the secret that it was made with"
        )
    return StudentAssignment(student, master, problems, values)


def run_answers(harvester, own, answers):
    """Run the answers of a :class:`StudentAssignment` in the sandbox; returns ({problem id:
    receipt}, note).

    The note says how the run differed from a complete one in the sandbox; it is "" if it did not.
    """
    cells = [
        {
            "id": p.id,
            "givens": nb.givens(p, own.values[p.id]),
            "cell": answers[p.id].text,
            "forms": {a.key: nb.form(a) for a in p.answers},
            "symbols": {n: s.unit for n, s in p.symbols.items()},
        }
        for p in own.problems
        if not is_untouched(p, answers[p.id].text)
    ]
    if not cells:
        return {}, ""
    result = harvester.run(nb.SETUP, cells)
    receipts, notes = result["receipts"], []
    if result["sandbox"] != "namespaces":
        notes.append(f"unsandboxed: this machine refused the cage ({result['sandbox']})")
    if result["ended"] != "done":
        notes.append(f"the notebook was {result['ended']}; answers that came later were not read")
    elif unread := [c["id"] for c in cells if c["id"] not in receipts]:
        notes.append(
            f"the notebook ended by itself in the cell of {unread[0]}; answers that came later "
            "were not read"
        )
        receipts = {
            **receipts,
            unread[0]: {
                "error": "the end of its process: the cell ended Python, crashed it, or closed its "
                "files"
            },
        }
    return receipts, "; ".join(notes)


def score_answers(own, answers, receipts):
    """The :class:`~grader.scoring.Score` of every problem: {problem id: score}."""
    return {
        p.id: score_receipt(p, own.values[p.id], receipts.get(p.id), answers[p.id].note)
        for p in own.problems
    }


def feedback_comment(score):
    """The feedback on one problem as Markdown, for nbgrader's automatic comment."""
    if all(part.message == NO_ANSWER for part in score.parts) and not score.note:
        return "No answer."
    lines = [f"- {MARK[part.verdict]} `{part.key}`: {part.message}" for part in score.parts]
    return "\n".join([*([f"Note: {score.note}", ""] if score.note else []), *lines])


def annotate(notebook, scores, note=""):
    """The rebuilt notebook with the verdicts as output of the receipt cells, and ``note`` above the
    introduction.
    """
    cells = []
    for cell in notebook["cells"]:
        own = nb.own_metadata(cell)
        if own.get("role") == "receipt":
            cell = {**cell, "outputs": [_output(scores[own["problem"]])]}
        elif own.get("role") == "introduction" and note:
            cell = {**cell, "source": f"> {note}\n\n{cell['source']}"}
        cells.append(cell)
    return {**notebook, "cells": cells}


def _output(score):
    rows = "".join(
        f"<tr><td>{MARK[p.verdict]}</td><td><code>{p.key}</code></td><td>{p.points:g} / "
        f"{p.out_of:g}</td><td>{html.escape(p.message)}</td></tr>"
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
            "text/html": f"{note}<table>{rows}</table>",
        },
    }
