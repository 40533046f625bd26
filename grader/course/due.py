"""The due date of an assignment."""

from datetime import UTC, datetime
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from .folder import Course
from .identity import CourseError


def due_date(text: str) -> datetime:
    """The time in UTC of "2027-01-31 23:59 Europe/Berlin"; without a zone, in this machine's."""
    text = text.strip()
    when, _, zone = text.rpartition(" ")
    try:
        if zone and ":" not in zone:  # otherwise it is the time of day
            found = datetime.fromisoformat(when).replace(tzinfo=ZoneInfo(zone))
        else:
            found = datetime.fromisoformat(text)
        return found.astimezone(UTC)
    except (ValueError, OverflowError, OSError, ZoneInfoNotFoundError) as error:
        raise CourseError(
            f"the due date {text!r}: expected a date, a time and the name of a zone, as in "
            "'2027-01-31 23:59 Europe/Berlin' or '2027-01-31 22:59 UTC'"
        ) from error


def set_due(course: Course, assignment: str, when: datetime) -> None:
    """Set the due date of an assignment in nbgrader's gradebook, which keeps it without a zone."""
    if not (course.path / "source" / assignment).is_dir():
        known = sorted(p.name for p in (course.path / "source").glob("*/"))
        raise CourseError(
            f"{course.path} has no assignment {assignment}; it has {', '.join(known) or 'none'}"
        )
    with course.gradebook() as book:
        book.update_or_create_assignment(assignment, duedate=when.replace(tzinfo=None))
