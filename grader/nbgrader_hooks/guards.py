"""What nbgrader must find before it grades or writes feedback: readers and writers of notebooks
that refuse to work without the configuration of the course, and read regular files only.

They are named in the course's nbgrader_config.json, which nbgrader reads even where the
instructor's nbgrader_config.py does not run. nbgrader only logs an error in that file and goes on
with its own steps, which would run students' code as the instructor; with these names it stops.
"""

import importlib
import os
from pathlib import Path

from nbconvert.exporters import HTMLExporter, NotebookExporter
from nbformat.v4 import new_notebook
from nbgrader.converters import base
from nbgrader.converters.base import NbGraderException
from nbgrader.coursedir import CourseDirectory
from traitlets import Unicode

from ..course import Course, CourseError
from ..submission.files import BESIDE
from ..submission.timestamps import read_timestamp

WRITTEN = "newton_euler_written"  # in the resources of nbconvert: the path of a notebook
MAX_FILE = 10 * 2**20  # of a file beside a submitted notebook
MAX_FILES = 200


def _course_path():
    return Unicode("", help="The course folder; set by grader.nbgrader_config.configure").tag(
        config=True
    )


class _Configured:
    """Refuses to start unless the whole nbgrader_config.py of the course has run."""

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        if not self.course_path:
            raise NbGraderException(
                self._said(
                    "nbgrader_config.py of this course did not run to its end (its error is "
                    "above): mend it. Without it students' code would run without a cage, and "
                    "without your settings; nothing was run"
                )
            )
        try:
            importlib.import_module(".preprocessors", __package__)
        except Exception as error:  # before a first submission is touched
            raise NbGraderException(
                self._said(
                    f"the grader cannot be imported ({error}): install the checkout again with "
                    "pip install -e '.[course]'; nothing was run"
                )
            ) from error
        try:
            Course(self.course_path).secret  # noqa: B018  # raises if it is gone or changed
        except CourseError as error:
            raise NbGraderException(self._said(str(error))) from error
        _leave_special_files_alone()
        self.log.addFilter(_one_line_each)  # which adds it once

    def _said(self, text):
        self.log.error(text)
        return text


class SubmissionReader(_Configured, NotebookExporter):
    """Gives ``nbgrader autograde`` an empty notebook in place of each: our steps read it
    themselves, as ``python -m grader grade`` does, and write what nbgrader is to write. nbformat
    would follow a link, wait for a pipe, and take 7 GB for 60 MB of brackets.
    """

    course_path = _course_path()

    def from_filename(self, filename, resources=None, **kwargs):
        name = {"name": Path(filename).stem, "path": str(Path(filename).parent)}
        resources = {**(resources or {}), "metadata": name}
        text, resources = self.from_notebook_node(new_notebook(), resources=resources, **kwargs)
        if written := resources.pop(WRITTEN, None):
            text = written.read_text(encoding="utf-8")
        return text, resources


class FeedbackPage(_Configured, HTMLExporter):
    """Writes feedback pages. Beside them only those of nbgrader's files are copied that it needs
    itself: a page is whole, and a student's file could stand in its place.
    """

    course_path = _course_path()

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        base.find_all_files = _nbgraders_own


def _leave_special_files_alone():
    """Make nbgrader copy regular files only, and read times that are none as no time.

    Its own functions follow links (to the course's secret), wait for pipes, and fail for the whole
    class at one student's timestamp.txt; no setting replaces them.
    """
    base.find_all_files = _regular_files
    CourseDirectory.get_existing_timestamp = lambda self, folder: read_timestamp(folder)


def _one_line_each(record):
    """A filter of nbgrader's log: students name files, and nbgrader writes the names to the
    terminal, where they could erase lines and add others.
    """
    if isinstance(record.args, tuple):
        record.args = tuple(_shown(x, "") if isinstance(x, str) else x for x in record.args)
    record.msg = _shown(str(record.msg), "\n\t")  # a traceback has several lines
    return True


def _shown(text, kept):
    return "".join(c if c.isprintable() or c in kept else "\ufffd" for c in text)


_find_all_files = base.find_all_files


def _regular_files(path, exclude=None):
    found = [f for f in _find_all_files(path, exclude) if _is_small_and_regular(f)]
    return found[:MAX_FILES]


def _nbgraders_own(path, exclude=None):
    own = {os.path.join(path, name) for name in BESIDE}
    return [f for f in _regular_files(path, exclude) if f in own]


def _is_small_and_regular(path):
    try:
        status = os.lstat(path)
    except OSError:
        return False
    return os.path.stat.S_ISREG(status.st_mode) and status.st_size <= MAX_FILE
