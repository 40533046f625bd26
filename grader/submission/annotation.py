"""The annotated notebook, as nbgrader's autograde leaves it for those who grade by hand."""

from collections.abc import Callable
from typing import Any

from markupsafe import escape

from exercises.catalogue import CatalogueError, problem
from newton_euler.algebra.language import _, cached_by_language
from newton_euler.answers.notation import is_word

from ..assignment.cells import Cell, Notebook, Sources, nbgrader_metadata, own_metadata
from ..scoring import Part, Score
from .mathml import mathml, unit_html
from .pipeline import MARK, NotebookGrade

NOTE = "note-of-grading"  # the id of the cell that holds the note where there is no introduction


def annotate(
    notebook: Notebook, graded: NotebookGrade, sources: Sources, earlier: str = ""
) -> Notebook:
    """The rebuilt notebook, or one annotated before with the note ``earlier``: with the verdicts in
    the receipt cells, a note on top, and the instructor's texts as in the gradebook.
    """
    cells, note = [], graded.note
    for cell in notebook["cells"]:
        own, name = own_metadata(cell), nbgrader_metadata(cell).get("grade_id")
        if name in sources:
            cell = _as_in_gradebook(cell, *sources[name])
        if own.get("role") == "receipt" and own["problem"] in graded.scores:
            cell = {**cell, "outputs": [_output(graded.scores[own["problem"]])]}
        elif own.get("role") == "introduction":
            text = cell["source"].removeprefix(_quoted(earlier))
            cell, note = {**cell, "source": _quoted(note) + text}, ""
        if cell.get("id") != NOTE:
            cells.append(cell)
    if note:  # an instructor deleted the introduction
        text = _quoted(note).strip()
        cells.insert(0, {"cell_type": "markdown", "id": NOTE, "metadata": {}, "source": text})
    return {**notebook, "cells": cells}


def _quoted(note: str) -> str:
    return f"> {note}\n\n" if note else ""


def _as_in_gradebook(cell: Cell, text: str, checksum: str) -> Cell:
    marks = {**nbgrader_metadata(cell), "checksum": checksum}
    cell = {**cell, "metadata": {**cell["metadata"], "nbgrader": marks}}
    if marks.get("locked") and not marks.get("solution"):
        cell["source"] = text
    return cell


def _output(score: Score) -> dict[str, Any]:
    """The verdicts as the output of a receipt cell, as HTML and as text."""
    lines = (
        f"{MARK[p.verdict]} {p.key}: {p.points:g} / {p.out_of:g}  {p.message}" for p in score.parts
    )
    text = "\n".join([score.note, *lines]).strip()
    data = {"text/plain": text, "text/html": _table(score)}
    return {"output_type": "display_data", "metadata": {}, "data": data}


def _table(score: Score) -> str:
    """The verdicts as a table whose headers a screen reader finds; what a student wrote is escaped.
    A template would take as long as the scoring.
    """
    symbol, value = _quantities(score.problem)
    rows = (
        f'<tr><th scope="row">{symbol(p)}<code>{escape(p.key)}</code></th><td>{value(p)}</td>'
        f"<td>{p.points:g} / {p.out_of:g}</td><td>{MARK[p.verdict]} {escape(p.message)}</td></tr>"
        for p in score.parts
    )
    note = f"<p>{escape(score.note)}</p>" if score.note else ""
    caption = escape(_("Problem {number}", number=score.problem))
    head = f"<table><caption>{caption}</caption><thead><tr>{_headers()}</tr></thead>"
    return f"{note}{head}<tbody>{''.join(rows)}</tbody></table>"


@cached_by_language
def _headers() -> str:
    headers = _("part"), _("value read"), _("points"), _("verdict")
    return "".join(f'<th scope="col">{escape(h)}</th>' for h in headers)


def _quantities(number: str) -> tuple[Callable[[Part], str], Callable[[Part], str]]:
    """How to show symbol and value of the answers; plainly if the problem no longer exists."""
    try:
        p = problem(number)
    except CatalogueError:
        return lambda part: "", lambda part: unit_html(part.read, "1")
    units = {a.key: a.unit for a in p.answers}

    def symbol(part: Part) -> str:
        known = part.key in units and not is_word(part.key)
        return f"{mathml(p.notation[part.key])} " if known else ""

    def value(part: Part) -> str:
        return mathml(part.latex) if part.latex else unit_html(part.read, units.get(part.key, "1"))

    return symbol, value
