"""Results as CSV: every part, or the files of Canvas, Moodle and Gradescope."""

import csv
import re
from pathlib import Path

from ..course import Course
from .records import part_scores, questions, student_rows

# a spreadsheet may run a text that begins with these, or has them after a character that ends a
# cell in another locale, perhaps behind quotes and invisible characters
_SIGNS = re.escape("=+-@−＝＋－＠﹦﹢﹣﹫⁼⁺⁻₌₊₋")
_UNSEEN = r"(?:[^\w !#-/:-@\[-`{-~]|[\u115f\u1160\u3164\uffa0])"
_RUNS = re.compile(
    rf"^(?=[\t\r\n]|(?:\s|{_UNSEEN})*[{_SIGNS}])"
    rf"|(?<=[;\t\r\n\v\f\x85\u2028\u2029])(?={_UNSEEN}*[{_SIGNS}])"
)


def export(
    course: Course, assignment: str, form: str, path: str | Path, penalties: bool = True
) -> tuple[int, int]:
    """Write results in one of :data:`FORMATS`; returns the numbers of students with cells to grade
    by hand and with penalties for lateness, which are subtracted unless ``penalties`` is False.
    """
    found, maximum = student_rows(course, assignment, penalties)
    rows = FORMATS[form](course, assignment, found, maximum)
    # spreadsheets need a byte-order mark
    with open(path, "w", newline="", encoding="utf-8-sig" if form == "parts" else "utf-8") as f:
        csv.writer(f).writerows(map(cell, row) for row in rows)
    return sum(line.waiting for line in found), sum(line.penalty > 0 for line in found)


def _parts(course, assignment, found, maximum):
    people = {line.id: line for line in found}
    yield (
        "student", "last_name", "first_name", "problem", "part", "points", "out_of", "verdict",
        "message", "diagnosis",
    )  # fmt: skip
    parts = part_scores(course, assignment)
    for e in (*parts, *questions(course, assignment, parts)):
        person = people.get(e.student)
        names = (person.last_name, person.first_name) if person else ("", "")
        yield (
            e.student, *names, e.problem, e.key, e.points, e.out_of, e.verdict, e.message,
            e.diagnosis or "",
        )  # fmt: skip


def _canvas(course, assignment, found, maximum):
    """Canvas finds a student by its own ID, or by the login; the second line is the maximum. An
    assignment of another name is created there.
    """
    yield ("Student", "ID", "SIS User ID", "SIS Login ID", "Section", assignment)
    yield ("    Points Possible", "", "", "", "", maximum)
    for line in found:
        name = ", ".join(filter(None, (line.last_name, line.first_name))) or line.id
        yield (name, line.lms_user_id, "", line.id, "", line.points)


def _moodle(course, assignment, found, maximum):
    """On import Moodle asks for the column that identifies students: "Email address", "ID number",
    or "Username", which holds the same id.
    """
    yield ("First name", "Last name", "ID number", "Username", "Email address", assignment)
    for line in found:
        names = (line.first_name, line.last_name)
        yield (*names, line.id, line.id, line.email, line.points)


def _gradescope(course, assignment, found, maximum):
    """The columns of Gradescope's download of grades."""
    yield (
        "First Name", "Last Name", "SID", "Email", "Sections", assignment,
        f"{assignment} - Max Points",
    )  # fmt: skip
    for line in found:
        names = (line.first_name, line.last_name)
        yield (*names, line.id, line.email, "", line.points, maximum)


def cell(x: str | float | None) -> str:
    """A cell of a CSV file: a number, or a text that spreadsheets do not take for a formula.

    >>> cell(0.5), cell("=1+1"), cell("Ada;=1+1")
    ('0.5', "'=1+1", "Ada;'=1+1")
    """
    if not isinstance(x, str):
        return "" if x is None else f"{x:.10g}"
    return _RUNS.sub("'", x)


FORMATS = {"parts": _parts, "canvas": _canvas, "moodle": _moodle, "gradescope": _gradescope}
