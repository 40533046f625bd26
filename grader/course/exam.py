"""Exams: assignments with a window of time, one attempt, and numbers used nowhere else.

The settings of an exam are in course.json. It closes at its due date, for a student with an
extension at theirs (:mod:`~grader.course.due`). A student's first work within the window counts,
since whoever has handed in may talk; without one, the first work of all, which by the exam's rule
is refused if late, or graded with a remark. An instructor can make another one count (``take-in
--replace``).
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING

from newton_euler.algebra.language import _

from .due import extensions, is_over
from .folder import Course
from .identity import CourseError

if TYPE_CHECKING:
    from nbgrader.api import Gradebook

LATE = ("refuse", "mark")  # late work is not graded, or graded with a remark


class LateError(CourseError):
    """Work handed in after an exam closed is refused."""


@dataclass(frozen=True)
class ExamWindow:
    """The window of an exam, in UTC without a zone; None: unlimited.

    late : one of :data:`LATE`. extensions : {student: extra time}
    """

    opens: datetime | None = None
    closes: datetime | None = None
    late: str = LATE[0]
    extensions: Mapping[str, timedelta] = field(default_factory=dict)

    def closing(self, student: str) -> datetime:
        """The closing time for a student."""
        if self.closes is None:
            return datetime.max
        return self.closes + self.extensions.get(student, timedelta())

    def remark(self, student: str, when: datetime | None) -> str:
        """The remark on work of this time, "" within the window; raises :class:`LateError` if it is
        refused.
        """
        if when is None:
            return _("it is not known whether this was handed in during the exam")
        if self.opens and when < self.opens:
            return _("handed in {time} before the exam opened", time=_span(self.opens - when))
        late = when - self.closing(student)
        if late <= timedelta():
            return ""
        words = _("handed in {time} after the exam closed", time=_span(late))
        if self.late == "mark":
            return words
        raise LateError(
            f"was {words}, and is refused; give {student} another date (python -m grader due) "
            "to grade it, or let all late work be graded with a remark (late: mark)"
        )

    def first(self, student: str, times: Iterable[datetime]) -> datetime:
        """The time of the work that counts."""
        closes, opens = self.closing(student), self.opens or datetime.min
        return min(times, key=lambda t: (not opens <= t <= closes, t))


def _span(time):
    minutes = time.total_seconds() / 60
    return f"{minutes:.0f} min" if minutes >= 1 else f"{time.total_seconds():.0f} s"


def is_exam(course: Course, assignment: str) -> bool:
    """True if an assignment of the course is an exam."""
    return assignment in course.exams


def window(course: Course, book: "Gradebook", assignment: str) -> ExamWindow | None:
    """The window of an exam, None for other assignments. ``book``: the open gradebook."""
    if not is_exam(course, assignment):
        return None
    kept = course.exams[assignment]
    master = book.find_assignment(assignment)
    opens = datetime.fromisoformat(kept["opens"]) if kept["opens"] else None
    granted = {s.student_id: s.extension for s in master.submissions if s.extension}
    own = granted | extensions(course, assignment, master.duedate)
    return ExamWindow(opens, master.duedate, kept["late"], own)


def judged(
    course: Course, book: "Gradebook", assignment: str, times: Mapping[str, datetime | None]
) -> tuple[dict[str, str], dict[str, str]]:
    """({student: remark on the time of submission}, {student: why it is refused}) for an exam; ({},
    {}) for other assignments.
    """
    remarks: dict[str, str] = {}
    refused: dict[str, str] = {}
    if not (found := window(course, book, assignment)):
        return remarks, refused
    for student, when in times.items():
        try:
            remarks[student] = found.remark(student, when)
        except LateError as error:
            refused[student] = str(error)
    return remarks, refused


def set_exam(course: Course, assignment: str, opens: datetime | None, late: str = LATE[0]) -> None:
    """Make an assignment an exam, before any sheet is handed out."""
    if not is_exam(course, assignment) and any(
        (course.path / place / assignment).exists() for place in ("numbers", "personal")
    ):
        raise CourseError(
            f"{assignment} was handed out as homework; an exam has numbers of its own: build it "
            "under another name"
        )
    text = opens.astimezone(UTC).replace(tzinfo=None).isoformat() if opens else ""
    course.set(exams={**course.exams, assignment: {"opens": text, "late": late}})


def refuse_exam(course: Course, assignment: str, what: str) -> None:
    """Raise :class:`CourseError` with the reason ``what`` if an assignment is an exam."""
    if is_exam(course, assignment):
        raise CourseError(f"{assignment} is an exam: {what}")


def refuse_feedback(course: Course, assignment: str) -> None:
    """Raise :class:`CourseError` while an exam can still be handed in."""
    if is_exam(course, assignment) and not is_over(course, assignment):
        raise CourseError(
            f"the exam {assignment} is not over for everybody, and feedback would give away the "
            "answers; write it when the exam has closed, even for those with their own date"
        )


def refuse_before_opening(course: Course, assignment: str, now: datetime | None = None) -> None:
    """Raise :class:`CourseError` before an exam opens."""
    opens = course.exams.get(assignment, {}).get("opens")
    if opens and (now or datetime.now(UTC).replace(tzinfo=None)) < datetime.fromisoformat(opens):
        raise CourseError(
            f"the exam {assignment} opens at {opens} UTC: release it then, since students can "
            "fetch what is released"
        )
