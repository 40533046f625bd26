"""Worked solutions on the feedback page, once the assignment is closed to everybody."""

from typing import Any

from nbformat import NotebookNode
from nbgrader.preprocessors import NbGraderPreprocessor
from traitlets import Enum

from ..assignment.released import released, sheet_numbers
from ..assignment.solution import worked_solution
from ..course.due import is_over
from .grading_page import html_with_mathml
from .shared import OfCourse, Processed


class WorkedSolutions(OfCourse, NbGraderPreprocessor):
    """Adds worked solutions, in the student's own numbers, to the sections of the page."""

    solutions = Enum(
        ["never", "after the due date", "always"],
        "never",
        help="Whether the feedback page shows worked solutions, which hold the answers, of the "
        "problems for which the sheet sets no level of help. The due date is the latest of all "
        "students, with their extensions.",
    ).tag(config=True)

    def preprocess(self, notebook: NotebookNode, resources: dict[str, Any]) -> Processed:
        names, course = resources["nbgrader"], self.course
        asked = released(course, names["assignment"])[names["notebook"]].tasks
        over = self.solutions == "always" or is_over(course, names["assignment"])
        by_default = "none" if self.solutions == "never" else "solution"
        shown = {i for i, t in asked.items() if over and (t.help or by_default) == "solution"}
        if not shown:
            return notebook, resources
        values = sheet_numbers(course, names["assignment"], names["student"])
        for section in resources["newton_euler"]["sections"]:
            if section.name in shown:
                p = asked[section.name].exercise
                known = {**values[p.id], **p.sympy_symbols()}
                section.solution = html_with_mathml(worked_solution(p, known, text=False))
        return notebook, resources
