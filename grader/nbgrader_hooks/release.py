"""Replaces nbgrader's release, so that the personal copies are made with it."""

from nbgrader.exchange.default import ExchangeReleaseAssignment

from ..assignment import copy_to_exchange, make_personal_copies
from ..course import Course


class ReleaseWithPersonal(ExchangeReleaseAssignment):
    """Releases the assignment, then makes each student's own copy and puts it into the exchange."""

    def copy_files(self):
        super().copy_files()
        course, assignment = Course(self.coursedir.root), self.coursedir.assignment_id
        students = course.roster()
        if not students:
            self.log.warning(
                "Nobody is on the roster: no personal copies. Add students, then: python "
                "-m grader personal %s --course . --exchange",
                assignment,
            )
            return
        paths = make_personal_copies(course, assignment, students)
        copy_to_exchange(course, assignment, self.dest_path, paths)
        self.log.info("Made %d personal copies", len(paths))
