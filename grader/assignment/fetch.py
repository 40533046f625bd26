"""Replaces nbgrader's fetch for students, so that each gets the copy with their own numbers.

This file is copied into COURSE/student/ and runs on the students' side, where grader and exercises
are not installed; it imports neither and holds no secret. The copies are made at release, in
folders that can be entered but not listed, under names derived from the student ids.
"""

import hashlib
import os
import shutil

from nbgrader.exchange.default import ExchangeFetchAssignment
from nbgrader.utils import get_username

FOLDER = ".personal"


def personal_name(course_id: str, assignment: str, student: str) -> str:
    """The name of the folder of a student's own copy, in ``outbound/.personal/<assignment>``."""
    return hashlib.sha256(f"{course_id}\0{assignment}\0{student}".encode()).hexdigest()[:32]


def who_submits(student_id: str) -> str:
    """The id under which nbgrader will submit: a student fetches under the same one."""
    return student_id if student_id not in ("", "*") else get_username()


class PersonalFetch(ExchangeFetchAssignment):
    """Copies the released assignment and the student's own notebooks, and overwrites no work."""

    def copy_files(self) -> None:
        student = who_submits(self.coursedir.student_id)
        name = personal_name(self.coursedir.course_id, self.coursedir.assignment_id, student)
        own = os.path.join(self.outbound_path, FOLDER, self.coursedir.assignment_id, name)
        if not os.path.isdir(own):
            self.fail(
                f"{self.coursedir.assignment_id} has no copy for {student!r}. Ask the "
                "instructor to put you on the roster and to run: "
                f"python -m grader personal {self.coursedir.assignment_id} --course COURSE "
                "--exchange"
            )
        present = os.listdir(self.dest_path) if os.path.isdir(self.dest_path) else []
        missing = set(os.listdir(own)) - set(present)
        self.log.info("Source: %s", self.src_path)
        self.do_copy(self.src_path, self.dest_path)
        for name in missing:
            shutil.copy(os.path.join(own, name), self.dest_path)
        self.log.info("Fetched as: %s %s", self.coursedir.course_id, self.coursedir.assignment_id)
