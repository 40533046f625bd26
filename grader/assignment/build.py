"""Writes the source notebook of an assignment into a course folder."""

from exercises import catalogue
from exercises.catalogue import CatalogueError, problems

from ..course import Course, read_roster, write_json
from ..sandbox import CELL_SECONDS
from .figures import figure_png
from .notebook import build_notebook


def select_problems(chapter, only):
    """The problems of a chapter, or those of them whose numbers are in ``only``."""
    found = problems(chapter)
    unknown = set(only) - {p.id for p in found}
    if unknown:
        raise CatalogueError(
            f"{chapter} has no problem {sorted(unknown)[0]}; it has {found[0].id} to {found[-1].id}"
        )
    return [p for p in found if not only or p.id in only]


def build_assignment(course_path, chapter, students=None, only=(), update=False, bar=None):
    """Write the source notebook of a chapter into a new course, or with ``update`` into an existing
    one; returns (course, path).

    students : path of a roster as CSV. only : numbers of the problems to include; default: all. bar
        : a ``rich`` progress bar.
    """
    selected, title = select_problems(chapter, only), catalogue.chapter(chapter).title
    roster = read_roster(students) if students else []
    if update:
        course = Course(course_path)
    else:
        # before the figures are drawn; the folder is made after them, so that a failure leaves
        # nothing behind
        Course.refuse_existing(course_path)
    task = bar.add_task("drawing figures", total=len(selected)) if bar else None
    figures = {}
    for p in selected:
        figures[p.id] = figure_png(p, p.book_values)
        if bar:
            bar.advance(task)
    course = course if update else Course.create(course_path)
    write_json(
        course.source(chapter), build_notebook(selected, title, CELL_SECONDS, figures=figures)
    )
    if roster:
        course.enrol(roster)
    return course, course.source(chapter)
