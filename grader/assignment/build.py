"""Writes the source notebook of an assignment into a course folder."""

import contextlib
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from exercises import catalogue
from exercises.catalogue import CatalogueError, Problem, problems

from ..course import Course, read_roster, write_json
from ..course.creation import new_course, refuse_existing, write_pinned
from ..sandbox import CELL_SECONDS, SECONDS
from .figures import figure_png
from .notebook import build_notebook


@dataclass(frozen=True)
class Built:
    """The course, the source notebook, the number of new students, and how the roster was read."""

    course: Course
    path: Path
    enrolled: int = 0
    read_as: str = ""


def select_problems(chapter: str, only: Collection[str]) -> list[Problem]:
    """The problems of a chapter, or those of them whose numbers are in ``only``."""
    found = problems(chapter)
    unknown = set(only) - {p.id for p in found}
    if unknown:
        raise CatalogueError(
            f"{chapter} has no problem {sorted(unknown)[0]}; it has {found[0].id} to {found[-1].id}"
        )
    return [p for p in found if not only or p.id in only]


def build_assignment(
    course_path: str | Path,
    chapter: str,
    students: str | Path | None = None,
    only: Collection[str] = (),
    update: bool = False,
    bar: Any = None,
    name: str | None = None,
    exchange: str | Path | None = None,
    id_column: str | None = None,
) -> Built:
    """Write the source notebook of a chapter, or of the problems ``only``, into a new course, or
    with ``update`` into an existing one.

    students : path of a roster as CSV; id_column : the header of its ids. bar : a ``rich`` progress
        bar. name, exchange : of a new course
    """
    selected, title = select_problems(chapter, only), catalogue.chapter(chapter).title
    roster = read_roster(students, id_column) if students else None
    if not update:
        refuse_existing(course_path)
    opened = (
        contextlib.nullcontext(Course(course_path))
        if update
        else new_course(course_path, name, exchange)
    )
    # drawn before the folder is made, so that a failure leaves nothing behind
    figures = _figures(selected, bar)
    with opened as course:
        path = course.source(chapter)
        write_json(path, build_notebook(selected, title, CELL_SECONDS, SECONDS, figures=figures))
        enrolled = course.enrol(roster.students) if roster else 0
    if update:
        write_pinned(course.path)  # a course of an earlier version has none
    return Built(Course(course_path), path, enrolled, roster.read_as if roster else "")


def _figures(selected: list[Problem], bar: Any) -> dict[str, bytes | None]:
    task = bar.add_task("drawing figures", total=len(selected)) if bar else None
    figures = {}
    for p in selected:
        figures[p.id] = figure_png(p, p.book_values)
        if bar:
            bar.advance(task)
    return figures
