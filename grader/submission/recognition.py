"""Which cell of the trusted notebook a submitted cell is: by the metadata and ids that were handed
out, or by its text where an editor has removed those.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from typing import Any

from newton_euler.algebra.language import in_all

from ..assignment.cells import Notebook, nbgrader_metadata, own_metadata
from ..assignment.notebook import GIVEN, WORK

OWN = "own"  # the role of a cell that the student added


@cache
def _first_lines():
    """{role: pattern} of the first line of our cells, in any language."""
    given, work = (
        "|".join(re.escape(text.partition(";")[0]) for text in in_all(x)) for x in (GIVEN, WORK)
    )
    return {
        "setup": r"from math import pi$",
        "statement": r"## (?P<problem>[\w/]+) ",
        "givens": rf"# (?P<problem>[\w/]+): (?:{given})",
        "answer": rf"# (?P<problem>[\w/]+): (?:{work})",
        "receipt": r"expect\(\"(?P<problem>[\w/]+)\"",
    }


Places = Mapping[tuple[str | None, ...] | None, int]


def places_by_name(master: Notebook) -> Places:
    """The number of each cell of a notebook by its names, the same for all students."""
    known: dict[tuple[str | None, ...] | None, int] = {}
    for n, cell in enumerate(master["cells"]):
        for name in cell_names(cell):
            known.setdefault(name, n)
    return known


def places_of(
    cells: Sequence[Mapping[str, Any]], master: Notebook, known: Places
) -> list[int | None]:
    """For each submitted cell the number of the cell of ``master`` that it is, None for those that
    the student added.
    """
    found = [next((known[m] for m in cell_names(c) if m in known), None) for c in cells]
    by_name = set(found)
    for n, submitted in enumerate(cells):
        if found[n] is None and (at := known.get(_name_in_text(submitted))) not in by_name:
            found[n] = at
    return _with_answers(cells, found, master)


def _with_answers(cells, found, master):
    """The same with the answers that are still missing: an answer is the only code cell next to the
    statement, numbers or receipt of its problem that assigns to a name that is asked for.
    """
    unmet = sorted({*range(len(master["cells"]))} - {*found})
    marks = {n: own_metadata(master["cells"][n]) for n in unmet}
    missing = {own["problem"]: n for n, own in marks.items() if own.get("role") == "answer"}
    if not missing:
        return found
    problems = [own_metadata(c).get("problem") for c in master["cells"]]
    above, below = _nearest(found), _nearest(found[::-1])[::-1]
    for problem, at in missing.items():
        asked = "|".join(map(re.escape, own_metadata(master["cells"][at])["asked"]))
        gives = re.compile(rf"(?:^|[,(\s])(?:{asked})\b")
        beside = [
            n
            for n, cell in enumerate(cells)
            if found[n] is None
            and {problems[m] for m in (above[n], below[n]) if m is not None} == {problem}
            and cell.get("cell_type") == "code"
            and any(map(gives.search, _left_of_equals(text_of(cell))))
        ]
        if len(beside) == 1:
            found[beside[0]] = at
    return found


def _left_of_equals(text):
    """What stands left of each "="; one pattern for all of it would take quadratic time."""
    lines = text.replace("==", "\n").split("\n")
    return [part for line in lines for part in line.split("=")[:-1]]


def _nearest(found):
    """For each cell the place of the nearest one before it that has one."""
    last, nearest = None, []
    for place in found:
        nearest.append(last)
        last = place if place is not None else last
    return nearest


def cell_names(cell: Mapping[str, Any]) -> Iterator[tuple[str | None, ...]]:
    """The names of a cell: grade id, role in a problem, id in the notebook; best first."""
    grade_id = nbgrader_metadata(cell).get("grade_id")
    if isinstance(grade_id, str) and grade_id:
        yield "grade", grade_id
    own = own_metadata(cell)
    role, problem = own.get("role"), own.get("problem")
    if isinstance(role, str) and isinstance(problem, str | None) and role != OWN:
        yield "role", role, problem
    if isinstance(cell.get("id"), str):
        yield "id", cell["id"]


def _name_in_text(cell: Mapping[str, Any]) -> tuple[str | None, ...] | None:
    """The role in a problem that the first line of a cell names."""
    line = text_of(cell).lstrip().partition("\n")[0]
    for role, pattern in _first_lines().items():
        if found := re.match(pattern, line):
            return "role", role, found.groupdict().get("problem")
    return None


def text_of(cell: Mapping[str, Any]) -> str:
    """The text of a submitted cell."""
    source = cell.get("source", "")
    return "".join(map(str, source)) if isinstance(source, list) else str(source)
