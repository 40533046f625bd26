"""A new course from last year's: the instructor's work, without anything about students."""

import os
import shutil
from datetime import timedelta
from pathlib import Path

from .creation import new_course
from .due import due_dates, set_due
from .files import write_text
from .folder import Course
from .identity import CourseError

ONE_YEAR = {"id", "secret_sha256", "exams"}  # settings not taken over
WRITTEN = "source", "built"  # the notebooks as edited, and as built, for later merges


def next_year(
    last: Course,
    path: str | Path,
    name: str | None = None,
    exchange: str | Path | None = None,
    later: timedelta | None = None,
) -> tuple[Course, list[str]]:
    """(a new course in the folder ``path``, its assignments), with the notebooks, settings and own
    problems of ``last`` and a new id and secret, hence new numbers for every student; without
    students, work and grades.

    name, exchange : as for a new course; by default its exchange is that of ``last``
    later : shift of the due dates, except of exams; None: no due dates
    """
    settings = last.settings
    if not settings:
        raise CourseError(
            f"{last.path} was made by an earlier version, without course.json: build a new course, "
            "and copy the notebooks in source/ into it"
        )
    path = Path(path).resolve()
    if last.path in (path, *path.parents) or path in last.path.parents:
        raise CourseError(f"{path}: one course cannot lie in the other; name a folder beside it")
    with new_course(path, name, exchange or last.exchange) as course:
        if course.name == last.name:
            raise CourseError(
                f"both courses have the id {course.name}, by which the exchange tells courses "
                "apart: add another --name"
            )
        for folder in WRITTEN:
            if (last.path / folder).exists():
                shutil.copytree(last.path / folder, path / folder, ignore=_no_checkpoints)
        text = (last.path / "nbgrader_config.py").read_text(encoding="utf-8")
        if exchange:
            text += f"\nc.Exchange.root = {str(Path(exchange).resolve())!r}\n"
        write_text(path / "nbgrader_config.py", text, 0o644)
        course.set(**{k: x for k, x in settings.items() if k not in ONE_YEAR})
    for folder in settings.get("problems_from", ()):
        if not os.path.isabs(folder):
            shutil.copytree(last.path / folder, path / folder, ignore=_no_checkpoints)
    made = Course(path)
    if later is not None:
        for assignment, due in due_dates(last).items():
            if made.source(assignment).exists() and assignment not in last.exams:
                set_due(made, assignment, due + later)
    return made, sorted(p.parent.name for p in path.glob("source/*/*.ipynb"))


_no_checkpoints = shutil.ignore_patterns(".ipynb_checkpoints", "__pycache__")
