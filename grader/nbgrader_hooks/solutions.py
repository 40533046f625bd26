"""Worked solutions on the feedback page, once nobody can hand them in any more."""

from datetime import UTC, datetime, timedelta
from typing import Any

from nbformat import NotebookNode
from nbgrader.preprocessors import NbGraderPreprocessor
from traitlets import Enum

from ..assignment.released import released, sheet_numbers
from ..assignment.solution import worked_solution
from ..course import Course
from .grading_page import html_with_mathml
from .shared import Processed, course_path


class WorkedSolutions(NbGraderPreprocessor):
    """Adds worked solutions, in the student's own numbers, to the sections of the page."""

    solutions = Enum(
        ["never", "after the due date", "always"],
        "never",
        help="Whether the feedback page shows worked solutions: they hold the answers. The due "
        "date is the latest of all students, with their extensions.",
    ).tag(config=True)
    course_path = course_path()

    def preprocess(self, notebook: NotebookNode, resources: dict[str, Any]) -> Processed:
        names, course = resources["nbgrader"], Course(self.course_path)
        if self.solutions == "never" or not (
            self.solutions == "always" or is_over(course, names["assignment"])
        ):
            return notebook, resources
        values = sheet_numbers(course, names["assignment"], names["student"])
        asked = released(course, names["assignment"])[names["notebook"]].tasks
        for section in resources["newton_euler"]["sections"]:
            if section.name in asked:
                p = asked[section.name].exercise
                known = {**values[p.id], **p.sympy_symbols()}
                section.solution = html_with_mathml(worked_solution(p, known, text=False))
        return notebook, resources


def is_over(course: Course, assignment: str, now: datetime | None = None) -> bool:
    """True if an assignment has a due date that has passed for everybody, extensions included."""
    with course.gradebook() as book:
        master = book.find_assignment(assignment)
        if master.duedate is None:
            return False
        extensions = [s.extension or timedelta() for s in master.submissions]
        last = master.duedate + max(extensions, default=timedelta())
    return (now or datetime.now(UTC).replace(tzinfo=None)) > last
