"""A replacement of nbgrader's collect: regular files only, unstoppable by a single student."""

from datetime import datetime
from functools import cached_property
from pathlib import Path
from typing import Any

from nbgrader.exchange.default import ExchangeCollect
from nbgrader.utils import find_owner

from ..course import Course, check_id
from ..course.exam import ExamWindow, is_exam, window
from ..course.files import copy_regular

KILOBYTE = 1000  # the unit of nbgrader's limits


class CollectRegularFiles(ExchangeCollect):
    """Collects submissions without links, pipes and devices, and within nbgrader's limits
    ``CourseDirectory.max_file_size`` and ``max_dir_size``.
    """

    def _path_to_record(self, path: str) -> dict[str, Any]:
        # students name these folders, and nbgrader stops at an unexpected name
        try:
            record = super()._path_to_record(path)
            check_id(record["username"])  # neither ".." nor control characters
            if isinstance(record["timestamp"], datetime) and self._is_own(record["username"], path):
                return record
        except Exception:
            self.log.warning("Not a submission, left where it is: %r", path)
        return {"username": "", "filename": "", "timestamp": datetime.min}

    src_records: list[dict[str, Any]]  # set by nbgrader
    _window: ExamWindow | None = None

    def init_src(self) -> None:
        course, assignment = Course(self.coursedir.root), self.coursedir.assignment_id
        if is_exam(course, assignment):
            with course.gradebook() as book:
                self._window = window(course, book, assignment)
        super().init_src()

    def _sort_by_timestamp(self, records: list[dict[str, Any]]) -> list[dict[str, Any]]:
        """A student's records, beginning with the one that counts: in an exam, not the last."""
        if self._window is None or not records[0]["username"]:
            return super()._sort_by_timestamp(records)
        student = records[0]["username"]
        times = {r["timestamp"]: r for r in records}  # times in UTC, without a zone
        when = self._window.first(student, times)
        if len(records) > 1:
            self.log.warning(
                "%s handed in the exam %d times; the one of %s UTC counts",
                student, len(records), f"{when:%Y-%m-%d %H:%M:%S}",
            )  # fmt: skip
        return [times[when], *(r for r in records if r is not times[when])]

    def copy_files(self) -> None:
        if self._window is not None:
            # nbgrader updates with newer work, or before the due date with any that it has chosen
            self.update, self.before_duedate = False, self.update
        self.src_records = [r for r in self.src_records if r["username"]]
        super().copy_files()

    @cached_property
    def _roster(self):
        return set(Course(self.coursedir.root).roster())

    def _is_own(self, student: str, path: str) -> bool:
        """False if the submission claims to be by one student and belongs to another on the roster,
        who could thus replace a neighbour's work.
        """
        try:
            owner = find_owner(path)
        except (KeyError, OSError):
            return True
        if owner == student or owner not in self._roster:
            return True
        self.log.error("%r says it is by %s but belongs to %s", path, student, owner)
        return False

    def do_copy(self, src: str, dest: str, log: Any = None) -> None:
        limits = self.coursedir.max_file_size * KILOBYTE, self.coursedir.max_dir_size * KILOBYTE
        try:
            left_out = copy_regular(src, dest, *limits)
        except OSError as error:
            self.log.error("%r could not be collected: %s", src, error)
            return
        for name, why in left_out.items():
            self.log.warning("%r of %r was not collected: %s", name, Path(src).name, why)
