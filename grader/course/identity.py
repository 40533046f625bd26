"""Who a student is, and what a course is called: the ids that stand in folders, in nbgrader's
gradebook and in its exchange.
"""

import re
import unicodedata

_BAD_IN_ID = re.compile(r"[/\\+*?\[\]{}%<>:\"|\x00-\x1f\x7f]|^[.\s-]|\s$")
LONGEST_ID = 100  # the exchange puts assignment, time and 12 more characters behind it


class CourseError(ValueError):
    """Something in a course folder is missing or invalid; the message says what to do."""


def check_id(student_id):
    """The id, if folders and nbgrader's exchange can be named by it; otherwise raises
    :class:`CourseError`.
    """
    if not student_id or _BAD_IN_ID.search(student_id) or len(student_id) > LONGEST_ID:
        raise CourseError(
            f"{student_id!r} cannot be a student id: folders are named by it, and nbgrader "
            "splits names at '+'. "
            "Use letters, digits and . _ - @, beginning with a letter or digit; a number "
            "or a login name is best"
        )
    return student_id


def same_student(student_id):
    """What two ids have in common that would name one folder on some machine: upper and lower case
    and the ways to write an accent are not told apart.
    """
    return unicodedata.normalize("NFKC", student_id).casefold()


def course_id(name):
    """An id for a course of this name, of letters, digits, ``.``, ``_`` and ``-``: "Meca-2026" for
    "Méca 2026".

    It names a folder in nbgrader's exchange, which every student's machine must be able to write.
    """
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    return re.sub(r"[^A-Za-z0-9._-]+", "-", plain).strip("-._") or "course"
