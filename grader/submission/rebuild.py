"""Puts a student's work into the trusted notebook: only the texts of answers, and the texts and
pictures of cells that the student added.
"""

import copy
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from newton_euler.algebra.language import Words, _

from ..assignment.cells import (
    Cell,
    Notebook,
    code_cell,
    kind,
    markdown_cell,
    nbgrader_metadata,
    own_metadata,
)
from .checked import checked_notes
from .recognition import OWN, Places, places_by_name, places_of, text_of

EDITABLE = ("answer", "hand", "solution", "plain")  # kinds of cells whose text is the student's
# kinds whose text is ours, but which students also edit: they add imports, or numbers
ALSO_WORKED_IN = ("setup", "givens", "locked")
MOST_CELLS = 500  # cells that a student added
MOST_COPIES = 20  # copies of one cell
MOST_TEXT = 2**20  # characters of the cells that a student added, and of each answer
COPIES = Words("the notebook holds {count} copies of the answer cell; the first one was graded")
COPIES_FILLED_IN = Words(
    "the notebook holds {count} copies of the answer cell; the first one that was filled in was "
    "graded"
)
PICTURES = ("image/png", "image/jpeg", "image/gif")


@dataclass
class Work:
    """What rebuilding found: notes by problem (an answer cell is missing or was copied; how many
    wrong answers a receipt reported), grade ids of the answers left as they were handed out, a note
    on the whole.
    """

    notes: dict[str, str] = field(default_factory=dict)
    untouched: list[str] = field(default_factory=list)
    note: str = ""


def rebuild(
    master: Notebook, submitted: Mapping[str, Any], known: Places | None = None
) -> tuple[Notebook, Work]:
    """(the trusted notebook with a student's work in it, :class:`Work`): the cells of ``master`` in
    its order, each followed by those that the student added after it. ``known``: the places of its
    cells.
    """
    found, added, note = _sorted_out(master, submitted, known or places_by_name(master))
    cells, work = [_own_cell(*own) for own in added.get(None, [])], Work(note=note)
    types_added = {c["cell_type"] for own in added.values() for c, _ in own}
    for n, cell in enumerate(master["cells"]):
        what, copies = kind(cell), found.get(n, [])
        if what in EDITABLE:
            now, problem = _edited(cell, what, copies)
            if problem and what == "answer":
                work.notes[own_metadata(cell)["problem"]] = problem
            grade_id = nbgrader_metadata(cell).get("grade_id")
            # a person decides whether a missing cell is among the added ones
            lost = what == "hand" and not copies and cell["cell_type"] in types_added
            if grade_id and now and is_untouched(cell, now[0]["source"]) and not lost:
                work.untouched.append(grade_id)
        else:
            now = _trusted(cell, what, copies)
        cells += [*now, *(_own_cell(*own) for own in added.get(n, []))]
    for n, cell in enumerate((c for c in cells if own_metadata(c).get("role") == OWN), 1):
        cell["id"] = f"own-{n}"
    for number, note in checked_notes(master, submitted).items():
        work.notes[number] = "; ".join(filter(None, (work.notes.get(number), note)))
    return {**master, "cells": cells}, work


def _sorted_out(master, submitted, known):
    """({place in the master: submitted copies of its cell}, {place: [(cell, text)] that were added
    after it}, a note on the latter).
    """
    cells = [c for c in submitted["cells"] if isinstance(c, dict)]
    found: dict[int, list[Any]] = {}
    added: dict[int | None, list[tuple[Any, str]]] = {}
    last, count, size = None, 0, 0
    for cell, n in zip(cells, places_of(cells, master, known), strict=True):
        if n is not None:
            last = n if n not in found else last
            found.setdefault(n, []).append(cell)
            continue
        text = text_of(cell)
        if cell.get("cell_type") not in ("code", "markdown") or not text.strip():
            continue
        count, size = count + 1, size + len(text)
        if count <= MOST_CELLS and size <= MOST_TEXT:
            added.setdefault(last, []).append((cell, text))
    note = ""
    if count > MOST_CELLS or size > MOST_TEXT:
        note = _(
            "the notebook has {count} cells of the student's own, with {size} characters; only "
            "the first {cells} of them, with at most {text} characters, were used",
            count=count, size=size, cells=MOST_CELLS, text=MOST_TEXT,
        )  # fmt: skip
    return found, added, note


def _trusted(cell, what, copies):
    """The cell of the master, preceded by what the student added to it."""
    if what not in ALSO_WORKED_IN:
        return [_clean(cell)]
    ours = _our_code(cell["source"])
    worked = [(c, t) for c in copies[:MOST_COPIES] if _code_only(t := text_of(c)) != ours]
    worked = [(c, t) for c, t in worked if c.get("cell_type") == cell["cell_type"]]
    return [*(_own_cell(c, t[:MOST_TEXT]) for c, t in worked), _clean(cell)]


def _edited(cell, what, copies):
    """([the master's cell with the student's text], a note if it is missing or copied). A deleted
    plain cell is left out; several answers to be graded by hand are all kept.
    """
    if not copies:
        missing = {**_clean(cell), "source": "" if what == "answer" else cell["source"]}
        note = _(
            "the answer cell of {problem} is missing from the notebook; fetch the assignment again "
            "and paste your work into it",
            problem=own_metadata(cell).get("problem"),
        )
        return [] if what == "plain" else [missing], note if what == "answer" else ""
    texts = [text_of(c)[:MOST_TEXT] for c in copies[:MOST_COPIES]]
    changed = [n for n, t in enumerate(texts) if not is_untouched(cell, t)]
    at = changed[0] if changed else 0
    chosen = {**_clean(cell), "source": texts[at]}
    if cell["cell_type"] == "markdown" and (pictures := _pictures(copies[at])):
        chosen["attachments"] = pictures
    cells = [chosen]
    if what == "hand":
        others = [({**copies[n], "cell_type": cell["cell_type"]}, texts[n]) for n in changed[1:]]
        cells += [_own_cell(*other) for other in others]
    if len(copies) == 1:
        return cells, ""
    text = COPIES_FILLED_IN if changed else COPIES
    return cells, _(text, count=len(copies))


def is_untouched(cell: Cell, text: str) -> bool:
    """True if a text is empty or as in ``cell``; in code, up to comments and spaces."""
    if cell["cell_type"] != "code":
        return text.strip() in ("", cell["source"].strip())
    return _code_only(text) in ("", _our_code(cell["source"]))


def _code_only(text):
    return re.sub(r"\s+|#[^\n]*", "", text)


_our_code = lru_cache(maxsize=1000)(_code_only)  # our texts are mostly the same for all students


def _clean(cell):
    """A cell of the master without outputs."""
    return {**cell, "outputs": [], "execution_count": None} if cell["cell_type"] == "code" else cell


def _own_cell(cell: Mapping[str, Any], text: str) -> Cell:
    """A cell that a student added: only its text and its pictures."""
    if cell["cell_type"] == "code":
        return code_cell(OWN, text, {"role": OWN})
    own = markdown_cell(OWN, text, {"role": OWN})
    if pictures := _pictures(cell):
        own["attachments"] = pictures
    return own


def _pictures(cell):
    """The attachments of a cell that are pictures, with nothing else that they hold."""
    attachments = cell.get("attachments")
    found = {}
    for name, kinds in attachments.items() if isinstance(attachments, dict) else ():
        pictures = {
            k: v
            for k, v in (kinds.items() if isinstance(kinds, dict) else ())
            if k in PICTURES and isinstance(v, str) and re.fullmatch(r"[A-Za-z0-9+/=\s]*", v)
        }
        if pictures:
            found[name] = pictures
    return copy.deepcopy(found)
