"""Reads the answers of a submitted notebook and puts them into the trusted notebook of the student.

A submission is not trusted: only the text of its answer cells is used.
"""

import re
from dataclasses import dataclass

from ..assignment.notebook import answer_id, own_metadata, starter


@dataclass(frozen=True)
class SubmittedAnswer:
    """The text of a problem's answer cell, and a note if the cell is missing or was copied."""

    text: str
    note: str = ""


def read_answers(submitted, problems):
    """The answers in a submitted notebook: {problem id: :class:`SubmittedAnswer`}, one for each of
    ``problems``.
    """
    found = {}
    for cell in submitted.get("cells", []):
        if not isinstance(cell, dict):
            continue
        grade_id, text = _grade_id(cell), _text(cell)
        if grade_id.startswith("answer-"):
            found.setdefault(grade_id, []).append(text)
    return {p.id: _chosen(p, found.get(answer_id(p.id), [])) for p in problems}


def _chosen(p, texts):
    """The first text that was filled in, of all cells with the id of the answer cell."""
    if not texts:
        return SubmittedAnswer(
            "",
            f"the answer cell of {p.id} is missing from the notebook; fetch the assignment "
            "again and paste your work into it",
        )
    changed = [t for t in dict.fromkeys(texts) if _code_only(t) != _code_only(starter(p))]
    chosen = changed[0] if changed else texts[0]
    if len(texts) > 1:
        which = "the first one that was filled in" if changed else "the first one"
        return SubmittedAnswer(
            chosen, f"the notebook holds {len(texts)} copies of the answer cell; {which} was graded"
        )
    return SubmittedAnswer(chosen)


def _code_only(text):
    return re.sub(r"\s+|#[^\n]*", "", text)


def is_untouched(p, text):
    """True if the answer cell is empty or as it was handed out, up to comments and spaces."""
    return _code_only(text) in ("", _code_only(starter(p)))


def _grade_id(cell):
    try:
        return str(cell["metadata"]["nbgrader"]["grade_id"])
    except (KeyError, TypeError):
        return ""


def _text(cell):
    source = cell.get("source", "")
    text = "".join(map(str, source)) if isinstance(source, list) else str(source)
    # JSON can hold lone surrogates, which no file can
    return text.encode("utf-8", "replace").decode()


def rebuild_notebook(master, answers):
    """The trusted notebook ``master`` with the texts of the answers in it, and nothing else of the
    submission.
    """
    cells = []
    for cell in master["cells"]:
        own = own_metadata(cell)
        if own.get("role") == "answer":
            cell = {
                **cell,
                "source": answers[own["problem"]].text,
                "outputs": [],
                "execution_count": None,
            }
        elif cell["cell_type"] == "code":
            cell = {**cell, "outputs": [], "execution_count": None}
        cells.append(cell)
    return {**master, "cells": cells}
