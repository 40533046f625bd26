"""Worked solutions on the feedback page, once nobody can use them any more."""

from datetime import UTC, datetime, timedelta

from nbgrader.preprocessors import NbGraderPreprocessor
from traitlets import Enum, Unicode

from ..assignment.released import released_notebooks, sheet_numbers
from ..assignment.sheet import tasks
from ..assignment.solution import worked_solution
from ..course import Course
from .grading_page import html_with_mathml


class WorkedSolutions(NbGraderPreprocessor):
    """Adds the worked solution of each problem, in the student's own numbers, to the sections of
    the feedback page.
    """

    solutions = Enum(
        ["never", "after the due date", "always"],
        "never",
        help="Whether the feedback page shows worked solutions: they hold the answers. The due "
        "date is the latest of all students, with their extensions.",
    ).tag(config=True)
    course_path = Unicode(
        "", help="The course folder; set by grader.nbgrader_config.configure"
    ).tag(config=True)

    def preprocess(self, notebook, resources):
        names, course = resources["nbgrader"], Course(self.course_path)
        if self.solutions == "never" or not (
            self.solutions == "always" or is_over(course, names["assignment"])
        ):
            return notebook, resources
        released = released_notebooks(course, names["assignment"])[names["notebook"]]
        values = sheet_numbers(course, names["assignment"], names["student"])
        shown = {
            number: worked_solution(
                task.exercise, {**values[number], **task.exercise.sympy_symbols()}, text=False
            )
            for number, task in tasks(released).items()
        }
        for section in resources["newton_euler"]["sections"]:
            if section["name"] in shown:
                section["solution"] = html_with_mathml(shown[section["name"]])
        return notebook, resources


def is_over(course, assignment, now=None):
    """True if an assignment has a due date, and it is over for everybody, also with extensions."""
    with course.gradebook() as book:
        master = book.find_assignment(assignment)
        if master.duedate is None:
            return False
        extensions = [s.extension or timedelta() for s in master.submissions]
        last = master.duedate + max(extensions, default=timedelta())
    return (now or datetime.now(UTC).replace(tzinfo=None)) > last
