"""One grader at a time in a course."""

import contextlib
import fcntl
import os

from ..course import CourseError


@contextlib.contextmanager
def alone(course):
    """Hold the lock of a course, which ends with the process that holds it; raises
    :class:`CourseError` if another run has it.
    """
    path = course.path / "scores" / ".lock"
    path.parent.mkdir(exist_ok=True)
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT, 0o600)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        os.close(descriptor)
        raise CourseError(
            f"another run is grading in {course.path}; wait for its end, then grade again"
        ) from None
    try:
        yield
    finally:
        os.close(descriptor)
