"""Making an assignment in a course folder."""

from pathlib import Path

from exercises import catalogue
from exercises.catalogue import CatalogueError, problems

from ..course import Course, CourseError, read_roster, write_json
from ..sandbox.harvester import CELL_SECONDS
from . import notebook as nb
from .figures import png


def chosen(chapter, only):
    """The problems of a chapter, or those of them that are named."""
    found = problems(chapter)
    unknown = set(only) - {p.id for p in found}
    if unknown:
        raise CatalogueError(f"{chapter} has no problem {sorted(unknown)[0]}; it has {found[0].id} to {found[-1].id}")
    return [p for p in found if not only or p.id in only]


def build_assignment(course_path, chapter, students=None, only=(), update=False, bar=None):
    """Write the source notebook of a chapter, into a new course or with ``update`` an existing one; returns (course, path)."""
    picked, title = chosen(chapter, only), catalogue.chapter(chapter).title
    roster = read_roster(students) if students else []
    if update:
        course = Course(course_path)
    else:
        Course.refuse_existing(course_path)  # before the work, and the folder after it: nothing is left half-made
    task = bar.add_task("drawing figures", total=len(picked)) if bar else None
    figures = {}
    for p in picked:
        figures[p.id] = png(p, p.book_values)
        if bar:
            bar.advance(task)
    course = course if update else Course.create(course_path)
    write_json(course.source(chapter), nb.build(picked, title, CELL_SECONDS, figures=figures))
    if roster:
        course.enrol(roster)
    return course, course.source(chapter)


def course_config(course):
    """The configuration in the course's nbgrader_config.py, with what the instructor added there."""
    from traitlets.config.loader import PyFileConfigLoader

    return PyFileConfigLoader("nbgrader_config.py", path=str(course.path)).load_config()


def exchange_outbound(course, assignment):
    """The folder of a released assignment in the exchange that the course's nbgrader_config.py names."""
    from nbgrader.exchange.default import Exchange

    root = Path(Exchange(config=course_config(course)).root)
    outbound = root / course.name / "outbound" / assignment
    if not outbound.is_dir():
        raise CourseError(f"{outbound} does not exist; release first: nbgrader release_assignment {assignment}")
    return outbound
