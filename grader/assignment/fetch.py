"""nbgrader's fetch for students: each gets the copy with their own numbers.

A file of its own, copied into COURSE/student/: it runs on the students' side, where neither grader nor exercises are installed, and knows no secret.
The copies are made at release, under a name that only the student id leads to, in folders that can be entered but not listed.
"""

import hashlib
import os
import shutil

from nbgrader.exchange.default import ExchangeFetchAssignment

FOLDER = ".personal"


def personal_name(course_id, assignment, student):
    """The folder of a student's own copy, below ``outbound/.personal/<assignment>``."""
    return hashlib.sha256(f"{course_id}\0{assignment}\0{student}".encode()).hexdigest()[:32]


class PersonalFetch(ExchangeFetchAssignment):
    """Copies the assignment, and then the student's own notebooks over it."""

    def copy_files(self):
        student = self.coursedir.student_id
        if student in ("", "*"):
            student = os.environ.get("JUPYTERHUB_USER") or os.environ.get("USER") or ""
        name = personal_name(self.coursedir.course_id, self.coursedir.assignment_id, student)
        own = os.path.join(self.outbound_path, FOLDER, self.coursedir.assignment_id, name)
        if not os.path.isdir(own):
            self.fail(
                f"{self.coursedir.assignment_id} has no copy for {student!r}. Ask the instructor to put you on the roster and to run: "
                f"python -m grader personal {self.coursedir.assignment_id} --course COURSE --exchange"
            )
        missing = [f for f in os.listdir(own) if not os.path.exists(os.path.join(self.dest_path, f))]  # never over work that is there already
        self.log.info("Source: %s", self.src_path)
        self.do_copy(self.src_path, self.dest_path)
        for name in missing:
            shutil.copy(os.path.join(own, name), self.dest_path)
        self.log.info("Fetched as: %s %s", self.coursedir.course_id, self.coursedir.assignment_id)
