"""Ids of students and courses, which name folders in the course and in the exchange."""

import re
import unicodedata

_BAD_IN_ID = re.compile(r"[/\\+*?\[\]{}%<>:\"|]|^[.\s-]|\s$")
LONGEST_ID = 100  # characters; the exchange appends assignment, time and 12 more


class CourseError(ValueError):
    """Something in a course folder is missing or invalid; the message says what to do."""


def check_id(student_id: str) -> str:
    """The id itself; raises :class:`CourseError` if it cannot name a folder."""
    named = student_id.isprintable() and not _BAD_IN_ID.search(student_id)
    if not student_id or not named or len(student_id) > LONGEST_ID:
        raise CourseError(
            f"{student_id!r} cannot be a student id: folders are named by it, and nbgrader "
            "splits names at '+'. "
            "Use letters, digits and . _ - @, beginning with a letter or digit; a number "
            "or a login name is best"
        )
    return student_id


# how two ids of same_student may differ
ONLY_BY = "only by upper and lower case or by how a letter is encoded"


def same_student(student_id: str) -> str:
    """A key that is equal for ids that name the same folder on some machine: without distinction of
    case or of the encodings of an accent.
    """
    folded = unicodedata.normalize("NFKC", student_id).casefold()
    return unicodedata.normalize("NFKC", folded)  # casefold takes some accents off their letters


def course_id(name: str) -> str:
    """An id for a course of this name: "Meca-2026" for "Méca 2026". It names a folder in nbgrader's
    exchange, on any machine.
    """
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9._-]+", "-", plain).strip("-._") or "course"
