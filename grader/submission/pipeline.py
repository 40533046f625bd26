"""One submission, from the notebook that came back to scores and an annotated notebook. Both grading routes go through here."""

import html
from dataclasses import dataclass

from ..assignment import notebook as nb
from ..course import CourseError
from ..scoring.score import OPEN, score

MARK = {"right": "✓", "wrong": "✗", "unreadable": "?", "blank": "–"}


@dataclass(frozen=True)
class Sheet:
    """An assignment of one student: the trusted notebook, its problems and the student's numbers."""

    student: str
    master: dict
    problems: list
    values: dict


def sheet(course, assignment, student):
    """The :class:`Sheet` of a student, derived from the course alone."""
    master = course.master(assignment, student)
    problems = nb.problems_of(master)
    values = course.values(assignment, student, problems)
    if differing := nb.shows_other_numbers(master, values):
        raise CourseError(
            f"the copy that {student} fetched ({course.personal_path(assignment, student)}) has other numbers for {differing} than are derived now: "
            "the exercises or the course's secret have changed since. Grade with the version and the secret that it was made with"
        )
    return Sheet(student, master, problems, values)


def harvested(harvester, own, answers):
    """Run the answers in a cage; returns ({problem: receipt}, a note on how it ran, "" if all went as it should)."""
    cells = [
        {
            "id": p.id,
            "givens": nb.givens(p, own.values[p.id]),
            "cell": answers[p.id].text,
            "forms": {a.key: nb.form(a) for a in p.answers},
            "symbols": {n: s.unit for n, s in p.symbols.items()},
        }
        for p in own.problems
        if not nb.is_untouched(p, answers[p.id].text)
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
        notes.append(f"the notebook ended by itself in the cell of {unread[0]}; answers that came later were not read")
        receipts = {**receipts, unread[0]: {"error": "the end of its process: the cell ended Python, crashed it, or closed its files"}}
    return receipts, "; ".join(notes)


def scored(own, answers, receipts):
    """{problem id: Score}."""
    return {p.id: score(p, own.values[p.id], receipts.get(p.id), answers[p.id].note) for p in own.problems}


def comment(result):
    """What the student reads about one problem, in Markdown: for nbgrader's comment."""
    if all(part.message == OPEN for part in result.parts) and not result.note:
        return "No answer."
    lines = [f"- {MARK[part.verdict]} `{part.key}`: {part.message}" for part in result.parts]
    return "\n".join([*([f"Note: {result.note}", ""] if result.note else []), *lines])


def annotated(notebook, scores, note=""):
    """The rebuilt notebook with the verdicts as output of the receipt cells."""
    cells = []
    for cell in notebook["cells"]:
        ours = cell["metadata"].get("newton_euler", {})
        if ours.get("role") == "receipt":
            cell = {**cell, "outputs": [_output(scores[ours["problem"]])]}
        elif ours.get("role") == "introduction" and note:
            cell = {**cell, "source": f"> {note}\n\n{cell['source']}"}
        cells.append(cell)
    return {**notebook, "cells": cells}


def _output(result):
    rows = "".join(
        f"<tr><td>{MARK[p.verdict]}</td><td><code>{p.key}</code></td><td>{p.points:g} / {p.out_of:g}</td><td>{html.escape(p.message)}</td></tr>"
        for p in result.parts
    )
    note = f"<p>{html.escape(result.note)}</p>" if result.note else ""
    text = "\n".join(f"{MARK[p.verdict]} {p.key}: {p.points:g} / {p.out_of:g}  {p.message}" for p in result.parts)
    return {
        "output_type": "display_data",
        "metadata": {},
        "data": {"text/plain": f"{result.note}\n{text}".strip(), "text/html": f"{note}<table>{rows}</table>"},
    }
