"""Shared by several hooks: a course, stopping at Ctrl-C."""

import contextlib
import logging
import sys
from collections.abc import Callable, Iterator
from typing import Any

from nbformat import NotebookNode
from traitlets import HasTraits, Unicode

from ..course import Course
from ..course.processes import ctrl_c_not_ignored

Processed = tuple[NotebookNode, dict[str, Any]]  # what a preprocessor returns

# key in nbconvert's resources: the path of the annotated notebook
WRITTEN = "newton_euler_written"


STOPPED = 130  # exit code after Ctrl-C, as of a shell


@contextlib.contextmanager
def ending_at_ctrl_c(log: logging.Logger, how_far: Callable[[], str]) -> Iterator[None]:
    """End the process at Ctrl-C in the block, with the progress as a sentence and no traceback."""
    try:
        with ctrl_c_not_ignored():
            yield
    except KeyboardInterrupt:
        log.error("Stopped by Ctrl-C: %s", how_far())
        sys.exit(STOPPED)


class OfCourse(HasTraits):
    """A hook of one course."""

    course_path = Unicode("", help="The course folder; set by .config.configure").tag(config=True)

    @property
    def course(self) -> Course:
        """The course."""
        return Course(self.course_path)
