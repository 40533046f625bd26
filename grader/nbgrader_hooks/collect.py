"""Replaces nbgrader's collect: copies only the regular files of each submission, and no student's
files stop it for the others.
"""

from datetime import datetime
from functools import cached_property
from pathlib import Path

from nbgrader.exchange.default import ExchangeCollect
from nbgrader.utils import find_owner

from ..course import Course, check_id
from ..course.files import copy_regular

KILOBYTE = 1000  # the unit of nbgrader's limits


class CollectRegularFiles(ExchangeCollect):
    """Collects what was handed in, without links, pipes and devices, and within nbgrader's limits
    ``CourseDirectory.max_file_size`` and ``max_dir_size``.
    """

    def _path_to_record(self, path):
        # students name these folders; nbgrader stops for all at a name that is not its own
        try:
            record = super()._path_to_record(path)
            check_id(record["username"])  # ".." is none, nor are codes that a terminal obeys
            if isinstance(record["timestamp"], datetime) and self._is_own(record["username"], path):
                return record
        except Exception:
            self.log.warning("Not a submission, left where it is: %r", path)
        return {"username": "", "filename": "", "timestamp": datetime.min}

    def copy_files(self):
        self.src_records = [r for r in self.src_records if r["username"]]
        super().copy_files()

    @cached_property
    def _roster(self):
        return set(Course(self.coursedir.root).roster())

    def _is_own(self, student, path):
        """False if the submission says it is by one student and belongs to another of the roster:
        with such a one a student could replace a neighbour's work.
        """
        try:
            owner = find_owner(path)
        except (KeyError, OSError):
            return True
        if owner == student or owner not in self._roster:
            return True
        self.log.error("%r says it is by %s but belongs to %s", path, student, owner)
        return False

    def do_copy(self, src, dest, log=None):
        try:
            left_out = copy_regular(
                src,
                dest,
                self.coursedir.max_file_size * KILOBYTE,
                self.coursedir.max_dir_size * KILOBYTE,
            )
        except OSError as error:
            self.log.error("%r could not be collected: %s", src, error)
            return
        for name, why in left_out.items():
            self.log.warning("%r of %r was not collected: %s", name, Path(src).name, why)
