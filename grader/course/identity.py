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


# how two ids of seen_as may differ, and why that is an error
ONLY_BY = (
    "only by upper and lower case, spaces, dots at the end, kinds of dashes or quotation marks, or "
    "how a letter is encoded"
)
TAKEN_FOR_ONE = "in a list they are taken for one, and on some machines they share a folder"
# what nobody sees: Unicode's Default_Ignorable_Code_Point
_UNSEEN = re.compile(
    "[\xad\u034f\u061c\u115f\u1160\u17b4\u17b5\u180b-\u180f\u200b-\u200f\u202a-\u202e"
    "\u2060-\u206f\u3164\ufe00-\ufe0f\ufeff\uffa0\ufff0-\ufff8\U000e0000-\U000e0fff]"
)
_ALIKE = (("[\u2010-\u2015\u2212]", "-"), ("[\u2018\u2019\u02bc]", "'"), (r"[\s\u2800]+", " "))


def seen_as(name: str) -> str:
    """A key that is equal for ids that a reader takes for one, or that name the same folder on some
    machine: they differ as :data:`ONLY_BY` says.
    """
    folded = name
    for _ in range(2):  # casefold takes some accents off their letters
        folded = _UNSEEN.sub("", unicodedata.normalize("NFKC", folded).casefold())
    for alike, plain in _ALIKE:
        folded = re.sub(alike, plain, folded)
    return folded.strip(" ").rstrip(" .")


def course_id(name: str) -> str:
    """An id for a course of this name: "Meca-2026" for "Méca 2026". It names a folder in nbgrader's
    exchange, on any machine.
    """
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9._-]+", "-", plain).strip("-._") or "course"
