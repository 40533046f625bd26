"""An assignment, read from its present source notebook in a course."""

import re
from collections.abc import Iterator, Mapping
from datetime import datetime

from exercises.catalogue import CatalogueError
from exercises.catalogue import problem as find_problem

from ..course import Course, CourseError, read_json
from .cells import Notebook, kind, nbgrader_metadata, own_metadata
from .options import OPTIONS
from .spec import Item, Spec

OTHERS = "test", "solution", "locked", "plain"  # kinds of an instructor's own cells
_FOR_GRADERS = re.compile(
    r"(?ms)^[^\n]*BEGIN (SOLUTION|MARK SCHEME)\b[^\n]*\n(.*?)^[^\n]*END \1\b[^\n]*$\n?"
)
_FIGURE = re.compile(r"!\[(?:\\.|[^\]])*\]\(attachment:[^)]*\)")


def spec_of_course(course: Course, name: str) -> Spec:
    """The assignment in its source notebook: problems, with their texts if the instructor has
    changed them, texts between them, and the instructor's questions for manual grading.
    """
    path, base = course.source(name), course.built(name)
    course.require(name)
    if not path.exists():
        raise CourseError(f"{path.parent} has no notebook {path.name}")
    notebook = read_json(path)
    built = {c["id"]: c["source"] for c in read_json(base)["cells"]} if base.exists() else {}
    found = [*_items(notebook, built)]
    items = tuple(x for x in found if isinstance(x, Item))
    left = tuple(x for x in found if isinstance(x, str))
    with course.gradebook() as book:
        due = next((a.duedate for a in book.assignments if a.name == name), None)
    exam = course.exams.get(name, {})
    opens = datetime.fromisoformat(exam["opens"]) if exam.get("opens") else None
    late = exam.get("late", "")
    texts = (c["source"] for c in notebook["cells"] if kind(c) == "introduction")
    title = next(texts, "").partition("\n")[0].removeprefix("# ")
    return Spec(name, title or name, items, _text(due), _text(opens), late, left)


def _text(when):
    return f"{when:%Y-%m-%d %H:%M} UTC" if when else ""


def _items(notebook: Notebook, built: Mapping[str, str]) -> Iterator[Item | str]:
    """The items, and the names of other cells."""
    changed: dict[str, str] = {}
    for cell in notebook["cells"]:
        role, text = kind(cell), cell["source"]
        if role == "statement" and text != built.get(cell["id"], text):
            changed[own_metadata(cell).get("problem", "")] = _FIGURE.sub("", text)
        elif role == "answer":
            try:
                yield _problem(cell, changed)
            except CatalogueError as error:
                yield str(error)
        elif role in ("hand", "task"):
            yield _question(cell)
        elif role.startswith("text-") or (role in OTHERS and cell["cell_type"] == "markdown"):
            yield Item(text=text)
        elif role in OTHERS:
            yield nbgrader_metadata(cell).get("grade_id") or "a cell of code"


def _problem(cell, changed):
    own, p = own_metadata(cell), find_problem(own_metadata(cell)["problem"])
    options = {key: own[key] for key in OPTIONS if key in own}  # type: ignore[literal-required]
    points = nbgrader_metadata(cell).get("points", 0)
    worth = {} if points == len(own.get("asked", p.answers)) else {"points": points}
    return Item(p, changed.get(p.id, ""), options=worth | options)


def _question(cell):
    """A manually graded cell; nbgrader replaces an answer without a solution region by its stub."""
    marks, source = nbgrader_metadata(cell), cell["source"]
    text, key = _FOR_GRADERS.sub("", source), _FOR_GRADERS.sub(r"\2", source)
    text = "" if text == source and marks.get("solution") else text
    if cell["cell_type"] == "code":
        text, key = (f"```\n{x.rstrip()}\n```" if x.strip() else "" for x in (text, key))
    points = {"points": marks.get("points", 0)}
    return Item(text=text, options=points, question=marks["grade_id"], key=key)
