"""Replacements of nbgrader's releases: that of an assignment makes the personal copies, that of
feedback publishes only our own pages.
"""

import contextlib
import shutil
from pathlib import Path

from nbgrader.exchange.default import ExchangeReleaseAssignment, ExchangeReleaseFeedback
from nbgrader.utils import notebook_hash

from ..assignment import copy_to_exchange, make_personal_copies
from ..assignment.personal import warning
from ..course import Course, CourseError
from ..course.exam import refuse_before_opening, refuse_feedback
from ..course.files import NotTaken, read_regular
from .shared import ending_at_ctrl_c

MAX_PAGE = 256 * 2**20
UNRELEASED = "nothing is released; running the command again starts over"


def _submission_secret(*folders: Path) -> str | None:
    """The secret that names a student's page in the exchange, made when they submitted."""
    for folder in folders:
        with contextlib.suppress(NotTaken, UnicodeDecodeError):
            return read_regular(folder / "submission_secret.txt", 1000).decode()
    return None


def _of_exams(rule, exchange):
    """The course and assignment of a step, which a rule of exams may refuse with a sentence."""
    course, assignment = Course(exchange.coursedir.root), exchange.coursedir.assignment_id
    try:
        rule(course, assignment)
    except CourseError as error:
        exchange.fail(str(error))
    return course, assignment


class ReleaseWithPersonal(ExchangeReleaseAssignment):
    """Makes each student's own copy, and puts them beside the released assignment."""

    def copy_files(self) -> None:
        course, assignment = _of_exams(refuse_before_opening, self)
        students = course.roster()
        if not students:
            super().copy_files()
            self.log.warning(
                "Nobody is on the roster: no personal copies. Add students, then: python "
                "-m grader personal %s --course . --exchange",
                assignment,
            )
            return
        if self.force or not Path(self.dest_path).is_dir():  # else super() refuses at once
            with ending_at_ctrl_c(self.log, lambda: UNRELEASED):
                self.log.info("Making %d personal copies", len(students))
                paths = make_personal_copies(course, assignment, students)
        super().copy_files()
        if words := warning(copy_to_exchange(course, assignment, self.dest_path, paths)):
            self.log.warning(words)


class ReleaseOwnPages(ExchangeReleaseFeedback):
    """Publishes the feedback pages of the assignment's notebooks, for each student who submitted
    through the exchange; other files in the folder are left out.
    """

    def copy_files(self) -> None:
        course, assignment = _of_exams(refuse_feedback, self)
        notebooks = [p.stem for p in course.released_path(assignment).parent.glob("*.ipynb")]
        excluded = set(filter(None, self.coursedir.student_id_exclude.split(",")))
        students = self.coursedir.student_id or "*"
        for folder in sorted(course.path.glob(f"feedback/{students}/{assignment}")):
            student = folder.parent.name
            if student in excluded:
                continue
            secret = _submission_secret(folder, course.path / "submitted" / student / assignment)
            if secret is None:
                self.log.warning(
                    "%s did not hand in through the exchange; give them %s yourself",
                    student, folder / f"{assignment}.html",
                )  # fmt: skip
                continue
            for name in notebooks:
                self._publish(
                    student, folder / f"{name}.html", notebook_hash(secret=secret, notebook_id=name)
                )

    def _publish(self, student, page, key):
        try:
            content = read_regular(page, MAX_PAGE)
        except NotTaken as reason:
            self.log.warning("%s of %s was not released: %s", page.name, student, reason)
            return
        target = Path(self.dest_path) / f"{key}.html"
        partial = target.with_suffix(".partial")
        partial.write_bytes(content)
        partial.chmod(0o644)
        shutil.move(partial, target)
        self.log.info("Released feedback for %s", student)
