"""The notebooks as generated for release, and the student's copies that grading trusts."""

import hashlib
import json
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

from exercises.catalogue import Problem

from ..course import Course, CourseError, load_json, read_json
from .cells import Cell, Notebook, SheetValues
from .notebook import personal_notebook
from .numbers import kept_numbers
from .sheet import Task, tasks

# metadata that affect the points of a cell, not how it runs
WORTH = ("points", "weights", "follow_through", "tolerance", "help", "checksum")


@dataclass(eq=False)
class ReleasedNotebook:
    """A notebook as generated for release; shared by all students, not to be modified."""

    path: Path

    @cached_property
    def notebook(self) -> Notebook:
        """Its cells, each with its source as one string."""
        return read_json(self.path)

    @cached_property
    def tasks(self) -> dict[str, Task]:
        """{number: task} of its problems."""
        return tasks(self.notebook)

    @cached_property
    def hashes(self) -> tuple[str, str]:
        """(hash of the file, hash of what affects its run: all but points, weights and figures)."""
        ran = json.dumps([_as_run(c) for c in self.notebook["cells"]], sort_keys=True)
        return _hash(self.path.read_bytes()), _hash(ran.encode())


def _as_run(cell: Cell) -> dict[str, Any]:
    metadata = {
        key: {k: v for k, v in marks.items() if k not in WORTH}
        for key, marks in cell["metadata"].items()
        if isinstance(marks, dict)
    }
    return {**cell, "attachments": None, "metadata": metadata}


def _hash(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:20]


def released(course: Course, assignment: str) -> dict[str, ReleasedNotebook]:
    """The notebooks of an assignment by name; raises :class:`CourseError` if it has none."""
    folder = course.released_path(assignment).parent
    found = {f.stem: _released(f, f.stat().st_mtime_ns) for f in sorted(folder.glob("*.ipynb"))}
    if not found:
        course.require_released(assignment)
    return found


@lru_cache(maxsize=16)
def _released(path: Path, changed: int) -> ReleasedNotebook:
    return ReleasedNotebook(path)


def personal_path(course: Course, assignment: str, student: str, name: str) -> Path:
    """The path of a student's own copy of one notebook of an assignment."""
    return course.personal_path(assignment, student).with_name(f"{name}.ipynb")


def problems_on_sheet(course: Course, assignment: str) -> list[Problem]:
    """The problems of all notebooks of an assignment."""
    asked = {i: t for r in released(course, assignment).values() for i, t in r.tasks.items()}
    return [task.exercise for task in asked.values()]


def sheet_numbers(course: Course, assignment: str, student: str) -> SheetValues:
    """A student's numbers for all problems of an assignment: {problem id: {name: number}}."""
    return kept_numbers(course, assignment, student, problems_on_sheet(course, assignment))


def master_notebook(
    course: Course,
    assignment: str,
    student: str,
    name: str | None = None,
    values: SheetValues | None = None,
) -> Notebook:
    """The trusted notebook of a student, by default the one named like the assignment: the released
    one with the student's numbers, and the figures of the copy that was handed out.
    """
    name = name or assignment
    found = released(course, assignment).get(name)
    if found is None:
        raise CourseError(f"{assignment} has no notebook {name}.ipynb")
    if not found.tasks:
        return found.notebook
    values = values or sheet_numbers(course, assignment, student)
    master = personal_notebook(found.notebook, student, values, {})
    path = personal_path(course, assignment, student, name)
    if path.exists():
        theirs = {c.get("id"): c for c in load_json(path.read_bytes())["cells"]}
        for n, cell in enumerate(master["cells"]):  # which all students share
            copy = theirs.get(cell.get("id"), {})
            if "attachments" in cell and "attachments" in copy:
                master["cells"][n] = {**cell, "attachments": copy["attachments"]}
    return master
