"""One grader at a time in a course."""

import contextlib
import fcntl
import os
from collections.abc import Iterator

from ..course import Course, CourseError


@contextlib.contextmanager
def alone(course: Course) -> Iterator[None]:
    """Hold the lock of a course; raises :class:`CourseError` if another run holds it."""
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
