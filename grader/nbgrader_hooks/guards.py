"""Exporters required by nbgrader for grading and feedback. They refuse to work unless the
configuration of the course is complete, and make nbgrader read regular files only.

The course's nbgrader_config.json names them. nbgrader reads that even if the instructor's
nbgrader_config.py fails, an error that it only logs before running students' code as the
instructor. With these names it stops.
"""

import logging
from pathlib import Path
from typing import Any, NoReturn

from nbconvert.exporters import HTMLExporter, NotebookExporter
from nbformat.v4 import new_notebook
from nbgrader.converters.base import NbGraderException

from ..course import CourseError
from ..course.exam import refuse_feedback
from .patches import copy_only_nbgraders_own_files, read_regular_files_only
from .shared import WRITTEN, OfCourse, ending_at_ctrl_c


class Configured(OfCourse):
    """Refuses to start unless the whole nbgrader_config.py of the course has run."""

    log: logging.Logger
    parent: Any

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        if not self.course_path:
            self._refuse(
                "nbgrader_config.py of this course did not run to its end (its error is above): "
                "correct it. Without it students' code would run without a cage, and without your "
                "settings; nothing was run"
            )
        try:
            from . import preprocessors  # noqa: F401  # before any submission is touched
        except Exception as error:
            self._refuse(
                f"the grader cannot be imported ({error}): install the checkout again with pip "
                "install -e '.[course]'; nothing was run"
            )
        try:
            self.course.secret  # noqa: B018  # raises if it is missing or changed
        except CourseError as error:
            self._refuse(str(error))
        read_regular_files_only()
        self.log.addFilter(_one_line_each)  # adding it twice has no effect
        converter = self.parent
        if hasattr(converter, "convert_notebooks"):
            stopping = ending_at_ctrl_c(self.log, lambda: _how_far(converter))
            converter.convert_notebooks = stopping(converter.convert_notebooks)

    def _refuse(self, why: str) -> NoReturn:
        self.log.error(why)
        raise NbGraderException(why)


class SubmissionReader(Configured, NotebookExporter):
    """Passes ``nbgrader autograde`` an empty notebook in place of each submission: our steps read
    the submission themselves, like ``python -m grader grade``, and produce the file that nbgrader
    writes. nbformat would follow links, wait for pipes, and take 7 GB for 60 MB of brackets.
    """

    def from_filename(
        self, filename: str, resources: dict[str, Any] | None = None, **kwargs: Any
    ) -> Any:
        name = {"name": Path(filename).stem, "path": str(Path(filename).parent)}
        resources = {**(resources or {}), "metadata": name}
        text, resources = self.from_notebook_node(new_notebook(), resources=resources, **kwargs)
        if written := resources.pop(WRITTEN, None):
            text = written.read_text(encoding="utf-8")
        return text, resources


class FeedbackPage(Configured, HTMLExporter):
    """Writes feedback pages. Only nbgrader's own files are copied with them: a page is complete,
    and a file of the student could replace it.
    """

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        copy_only_nbgraders_own_files()
        if (converter := self.parent) is not None:
            try:
                refuse_feedback(self.course, converter.coursedir.assignment_id)
            except CourseError as error:
                self._refuse(str(error))


def _how_far(converter):
    """The progress, as a sentence; nbgrader has removed the unfinished submission."""
    asked = sorted(converter.assignments)
    done = [sorted(converter.assignments[name]) for name in asked].index(converter.notebooks)
    return f"{done} of {len(asked)} are done and kept; the same command does the rest"


def _one_line_each(record: logging.LogRecord) -> bool:
    """A filter of nbgrader's log that removes control characters: names of students' files could
    erase or forge lines in the terminal.
    """
    if isinstance(record.args, tuple):
        record.args = tuple(_printable(x, "") if isinstance(x, str) else x for x in record.args)
    record.msg = _printable(str(record.msg), "\n\t")  # a traceback has several lines
    return True


def _printable(text: str, kept: str) -> str:
    return "".join(c if c.isprintable() or c in kept else "\ufffd" for c in text)
