"""The source notebook of an assignment, written into a course folder."""

import contextlib
import shutil
from collections.abc import Collection
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from exercises.catalogue import Problem

from ..course import Course, CourseError, load_json, read_roster, write_json
from ..course.creation import new_course, refuse_existing, write_pinned
from ..course.due import due_date
from ..course.exam import refuse_exam, set_exam
from ..course.files import write_text
from ..course.identity import ONLY_BY, TAKEN_FOR_ONE, seen_as
from ..sandbox import CELL_SECONDS, SECONDS
from .cells import own_metadata
from .figures import figure_png
from .merge import MergeResult, merged
from .notebook import build_notebook
from .spec import Spec, read_spec, spec_of

if TYPE_CHECKING:
    from rich.progress import Progress


@dataclass(frozen=True)
class BuildResult:
    """The result of a build: course, source notebook, assignment, number of new students, and how
    the roster was read.

    merged, backup : the merge with an existing notebook, and a copy of that notebook
    """

    course: Course
    path: Path
    spec: Spec
    enrolled: int = 0
    read_as: str = ""
    merged: MergeResult | None = None
    backup: Path | None = None


def build_assignment(
    course_path: str | Path,
    what: str | Spec,
    students: str | Path | None = None,
    only: Collection[str] = (),
    update: bool = False,
    bar: "Progress | None" = None,
    name: str | None = None,
    exchange: str | Path | None = None,
    id_column: str | None = None,
    chapters: str | None = None,
) -> BuildResult:
    """Write the source notebook of a chapter, of the problems ``only`` under the name ``what``, or
    of a :class:`~grader.assignment.spec.Spec`, into a new course, or with ``update`` into an
    existing one. An existing notebook is merged with what has changed
    (:mod:`~grader.assignment.merge`), and keeps its problems unless ``only`` is given.

    students : path of a roster as CSV; id_column : the header of its ids. bar : a ``rich`` progress
        bar. name, exchange : of a new course. chapters : where links lead, from now on in this
        course, see :func:`~exercises.catalogue.sections.section_line`
    """
    if not update:
        refuse_existing(course_path)
    if isinstance(what, Spec):
        spec = what
    else:
        kept = _built(course_path, what) if update and not only else None
        spec = kept or spec_of(what, only)
    roster = read_roster(students, id_column) if students else None
    opened = (
        contextlib.nullcontext(Course(course_path))
        if update
        else new_course(course_path, name, exchange)
    )
    # the figures before the folder, so that a failure leaves nothing behind
    figures = _figures(spec.problems, bar)
    with opened as course:
        if chapters is not None:
            course.set(chapters=chapters)
        _check_name(course, spec)
        links = course.settings.get("chapters", "")
        notebook = build_notebook(
            spec.items, spec.title, CELL_SECONDS, SECONDS, figures, links, bool(spec.late)
        )
        kept, backup = _write(course, spec, notebook)
        enrolled = course.enrol(roster.students) if roster else 0
    if update:
        write_pinned(course.path)  # courses of earlier versions have none
    read_as = roster.read_as if roster else ""
    path = course.source(spec.name)
    return BuildResult(Course(course_path), path, spec, enrolled, read_as, kept, backup)


def _check_name(course, spec):
    """Refuse a name too close to another assignment's; record whether it is an exam."""
    for other in (p.name for p in (course.path / "source").glob("*/")):
        if other != spec.name and seen_as(other) == seen_as(spec.name):
            raise CourseError(
                f"the assignments {other} and {spec.name} differ {ONLY_BY}: {TAKEN_FOR_ONE}"
            )
    if spec.late:
        set_exam(course, spec.name, due_date(spec.opens) if spec.opens else None, spec.late)
    else:
        refuse_exam(course, spec.name, "build it with --exam, or homework under another name")


def _write(course, spec, notebook):
    """Write a source notebook, merged with an existing one: (the merge, a copy of that one)."""
    name = spec.name
    path, base = course.source(name), course.built(name)
    kept = backup = None
    if path.exists():
        there = load_json(path.read_bytes())
        kept = merged(load_json(base.read_bytes()) if base.exists() else notebook, there, notebook)
        backup = course.path / "backup" / f"{name} {datetime.now():%Y-%m-%d %H.%M.%S.%f}.ipynb"
        backup.parent.mkdir(mode=0o700, exist_ok=True)
        shutil.copy(path, backup)
    write_json(path, kept.notebook if kept else notebook)
    write_json(base, notebook)
    write_text(base.with_suffix(".yaml"), spec.as_yaml)
    return kept, backup


def _built(course_path, name):
    """The assignment of the last build, or None."""
    base = Course(course_path).built(name)
    if (path := base.with_suffix(".yaml")).exists():
        return read_spec(path)
    cells = load_json(base.read_bytes())["cells"] if base.exists() else ()
    numbers = dict.fromkeys(p for c in cells if (p := own_metadata(c).get("problem")))
    return spec_of(name, numbers) if numbers else None


def _figures(selected: list[Problem], bar: "Progress | None") -> dict[str, bytes | None]:
    task = bar.add_task("drawing figures", total=len(selected)) if bar else None
    figures = {}
    for p in selected:
        figures[p.id] = figure_png(p, p.book_values)
        if bar and task is not None:
            bar.advance(task)
    return figures
