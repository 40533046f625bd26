"""One configuration for the students of several courses on one machine, as on a JupyterHub."""

from collections.abc import Sequence
from pathlib import Path

from .creation import write_for_students
from .folder import Course
from .identity import CourseError


def write_hub(courses: Sequence[Course], to: Path) -> str:
    """Write the students' configuration for these courses into the folder ``to``; returns their
    common exchange.
    """
    roots = {course.exchange for course in courses}
    names = [course.name for course in courses]
    if len(roots) > 1 or "" in roots:
        raise CourseError(
            "these courses need one exchange, which all their students reach: build them with the "
            "same --exchange, as /srv/nbgrader/exchange"
        )
    if len(set(names)) < len(names):
        raise CourseError(f"two of these courses have the id {names[0]}: build one with --name")
    (root,) = roots
    to.mkdir(parents=True, exist_ok=True)
    # without a course id nbgrader lists all courses; students get COURSE/ASSIGNMENT
    settings = f"c.Exchange.root = {root!r}\nc.Exchange.path_includes_course = True\n"
    write_for_students(to, settings)
    return root


def closed_to_others(folder: str | Path) -> Path | None:
    """The outermost folder on the path that other users cannot enter, or None."""
    path = Path(folder).resolve()
    shut = (p for p in [*reversed(path.parents), path] if p.exists() and not p.stat().st_mode & 1)
    return next(shut, None)
