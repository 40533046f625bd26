"""The due date of an assignment, for everybody and for single students.

A student's own date is kept in COURSE/extensions.json, since nbgrader can store it only after the
student has handed in; grading then writes it to the gradebook.
"""

import json
from collections.abc import Iterable
from datetime import UTC, datetime, timedelta
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError, available_timezones

from exercises.catalogue.errors import meant

from .files import write_json
from .folder import Course
from .identity import CourseError

EXTENSIONS = "extensions.json"  # ignored by git, since it names students


def due_date(text: str) -> datetime:
    """The time in UTC of "2027-01-31 23:59 Europe/Berlin"; without a zone, in this machine's."""
    text = text.strip()
    when, _, zone = text.rpartition(" ")
    if ":" in zone:  # a time of day
        when, zone = text, ""
    try:
        found = datetime.fromisoformat(when)
        return (found.replace(tzinfo=ZoneInfo(zone)) if zone else found).astimezone(UTC)
    except (ZoneInfoNotFoundError, OSError) as error:  # OSError: Europe is a folder of zones
        near = meant(zone, available_timezones()) if "/" in zone else ""
        near = near or "; write it as Europe/Berlin"
        raise CourseError(f"the due date {text!r}: there is no time zone {zone!r}{near}") from error
    except (ValueError, OverflowError) as error:
        raise CourseError(
            f"the due date {text!r}: expected a date, a time and the name of a zone, as in "
            "'2027-01-31 23:59 Europe/Berlin' or '2027-01-31 22:59 UTC'"
        ) from error


def set_due(course: Course, assignment: str, when: datetime | None) -> None:
    """Set or, with None, remove the due date of an assignment in nbgrader's gradebook, which keeps
    it without a zone.
    """
    course.require(assignment)
    due = when and when.replace(tzinfo=None)
    opens = course.exams.get(assignment, {}).get("opens")
    if opens and due and due <= datetime.fromisoformat(opens):
        raise CourseError(f"the exam {assignment} opens at {opens} UTC, after that date")
    with course.gradebook() as book:
        book.update_or_create_assignment(assignment, duedate=due)


def due_dates(course: Course) -> dict[str, datetime]:
    """{assignment: its due date, in UTC without a zone}."""
    with course.gradebook() as book:
        return {a.name: a.duedate for a in book.assignments if a.duedate}


def set_own_due(
    course: Course, assignment: str, students: Iterable[str], when: datetime | None
) -> None:
    """Give these students a due date of their own; None: the general one applies."""
    course.require(assignment)
    students = list(students)
    course.require_students(students)
    with course.gradebook() as book:
        due = book.find_assignment(assignment).duedate
    if when and not due:
        raise CourseError(
            f"{assignment} has no due date for everybody, without which nothing is late; set it "
            f"first: python -m grader due {assignment} '2027-01-31 23:59 Europe/Berlin'"
        )
    dates, own = _dates(course), {s: when.isoformat() for s in students} if when else {}
    kept = {s: date for s, date in dates.get(assignment, {}).items() if s not in students}
    dates[assignment] = kept | own
    write_json(course.path / EXTENSIONS, dates)
    with course.gradebook() as book:
        new = extensions(course, assignment, due)
        for submission in book.assignment_submissions(assignment):
            if submission.student_id in students:
                submission.extension = new.get(submission.student_id)
        book.db.commit()


def extensions(course: Course, assignment: str, due: datetime | None) -> dict[str, timedelta]:
    """{student: extension beyond ``due``, a time in UTC without a zone}."""
    own = _dates(course).get(assignment, {}) if due else {}
    dates = {s: datetime.fromisoformat(text).replace(tzinfo=None) for s, text in own.items()}
    return {s: date - due for s, date in dates.items()} if due else {}


def is_over(course: Course, assignment: str) -> bool:
    """True if the due date of an assignment has passed for everybody, extensions included."""
    with course.gradebook() as book:
        master = book.find_assignment(assignment)
        due = master.duedate
        if due is None:
            return False
        own = [s.extension for s in master.submissions if s.extension]
    last = due + max([timedelta(), *own, *extensions(course, assignment, due).values()])
    return datetime.now(UTC).replace(tzinfo=None) > last


def _dates(course):
    path = course.path / EXTENSIONS
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def set_late_share(course: Course, text: str) -> float:
    """Set the share that late work loses per day begun, from "none", "zero" or "10%"; return it."""
    words = {"none": 0.0, "zero": 1.0}
    try:
        share = words[text] if text in words else float(text.removesuffix("%")) / 100
    except ValueError:
        share = -1.0
    if not 0 <= share <= 1:
        raise CourseError(f"the late policy {text!r}: expected none, zero or a share, as in 10%")
    course.set(late_share_per_day=share)
    return share
