"""Preprocessors in place of nbgrader's own: they grade a submission like ``python -m grader
grade``, write the gradebook, and prepare the feedback page.
"""

import atexit
from base64 import b64encode
from functools import cache
from typing import Any

from nbformat import NotebookNode
from nbgrader.api import Gradebook
from nbgrader.converters.base import NbGraderException
from nbgrader.preprocessors import GetGrades, NbGraderPreprocessor

from ..assignment.cells import kind, nbgrader_metadata, own_metadata
from ..assignment.figures import figure_for_page
from ..assignment.released import released, sheet_numbers
from ..course.exam import judged
from ..grading.gradebook import Entry, instructors_cells, save
from ..grading.lock import alone
from ..grading.one import GradingResult, autograded_path, grade_one
from ..sandbox import Harvester
from ..submission import read_timestamp
from .shared import WRITTEN, OfCourse, Processed

_graded: dict[tuple[str, ...], GradingResult] = {}  # passed from the first step to the second


@cache
def shared_harvester() -> Harvester:
    """The harvester of this process, as nbgrader makes new preprocessors for every notebook."""
    harvester = Harvester(1).__enter__()
    atexit.register(harvester.__exit__)
    return harvester


def _key(resources):
    names = resources["nbgrader"]
    return names["db_url"], names["assignment"], names["student"], names["notebook"]


def _with_written(resources, course):
    """The resources with the path of the annotated notebook, for ``SubmissionReader``."""
    _, *names = _key(resources)
    return {**resources, WRITTEN: autograded_path(course, *names)}


class RebuildFromSource(OfCourse, NbGraderPreprocessor):
    """The only sanitize preprocessor of ``Autograde``: grades the trusted notebook with the
    student's work in it, not the submitted one.
    """

    def preprocess(self, notebook: NotebookNode, resources: dict[str, Any]) -> Processed:
        names, course = resources["nbgrader"], self.course
        assignment, student, name = names["assignment"], names["student"], names["notebook"]
        with Gradebook(names["db_url"]) as book:
            sources = instructors_cells(book, assignment)[name]
            time = read_timestamp(course.path / "submitted" / student / assignment)
            remarks, refused = judged(course, book, assignment, {student: time})
        if why := refused.get(student):
            raise NbGraderException(f"the work of {student} {why}")
        with alone(course):
            _graded[_key(resources)] = grade_one(
                course, assignment, student, name, sources, shared_harvester(),
                remark=remarks.get(student, ""),
            )  # fmt: skip
        return notebook, _with_written(resources, course)


class HarvestExecute(OfCourse, NbGraderPreprocessor):
    """Replaces ``Execute`` and the steps after it: writes the gradebook, including penalties."""

    def preprocess(self, notebook: NotebookNode, resources: dict[str, Any]) -> Processed:
        names, outcome = resources["nbgrader"], _graded.pop(_key(resources))
        course, student, name = self.course, names["student"], names["notebook"]
        time = read_timestamp(course.path / "submitted" / student / names["assignment"])
        graded = {name: outcome.graded}
        entry = Entry(student, graded, time, outcome.changed, outcome.again)
        with Gradebook(names["db_url"]) as book, alone(course):
            save(course, book, names["assignment"], [entry], only=name)
        if outcome.graded.note:
            self.log.warning("%s: %s", student, outcome.graded.note)
        return notebook, _with_written(resources, course)


class GradesAndFigures(OfCourse, GetGrades):
    """For the feedback page: adds points and comments, including manual ones, puts each figure into
    its text, and removes the instructor's hidden tests.
    """

    def preprocess(self, notebook: NotebookNode, resources: dict[str, Any]) -> Processed:
        names, course = resources["nbgrader"], self.course
        found = released(course, names["assignment"])[names["notebook"]]
        self._tasks = found.tasks
        self._numbers = sheet_numbers(course, names["assignment"], names["student"])
        self._released_texts = {
            nbgrader_metadata(c).get("grade_id"): c["source"]
            for c in found.notebook["cells"]
            if kind(c) in ("test", "task", "locked")
        }
        return super().preprocess(notebook, resources)

    def _get_comment(self, cell, resources):
        super()._get_comment(cell, resources)
        place = self.notebook_id, self.assignment_id, self.student_id
        comment = self.gradebook.find_comment(cell.metadata["nbgrader"]["grade_id"], *place)
        cell.metadata.nbgrader["manual_comment"] = comment.manual_comment

    def preprocess_cell(
        self, cell: NotebookNode, resources: dict[str, Any], index: int
    ) -> Processed:
        text = self._released_texts.get(nbgrader_metadata(cell).get("grade_id"))
        if text is not None:
            cell.source = text
        cell.pop("attachments", None)  # not shown, and could fill memory
        number = own_metadata(cell).get("problem")
        if kind(cell) == "statement" and number in self._tasks:
            svg = figure_for_page(self._tasks[number].exercise, self._numbers[number]) or b""
            inline = f"data:image/svg+xml;base64,{b64encode(svg).decode()}"
            cell.source = cell.source.replace("attachment:figure.png", inline)
        return super().preprocess_cell(cell, resources, index)
