"""Manual grades in the gradebook: points, extra credit, comments."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nbgrader.api import Gradebook

COLUMNS = ("manual_score", "extra_credit", "manual_comment", "needs_manual_grade")


def given_by_hand(rows: Iterable[Any]) -> dict[str, Any]:
    """The manually filled columns in the rows of one cell, its grade and its comment."""
    found = {n: x for row in rows for n in COLUMNS if (x := getattr(row, n, None)) is not None}
    return found if found.keys() - {"needs_manual_grade"} else {}


def give(row: Any, given: dict[str, Any]) -> None:
    """Set the manual columns of a grade or a comment, or clear them."""
    for name in COLUMNS[:-1]:
        if hasattr(row, name):
            setattr(row, name, given.get(name))
    if hasattr(row, "needs_manual_grade") and given:
        row.needs_manual_grade = given.get("needs_manual_grade", True)


def of_student(book: "Gradebook", assignment: str, student: str) -> dict[str, dict[str, Any]]:
    """{notebook: {cell: manual columns}} of one student's submission."""
    return {
        notebook.name: {
            name: given
            for name, rows in _by_cell(notebook).items()
            if (given := given_by_hand(rows))
        }
        for notebook in book.find_submission(assignment, student).notebooks
    }


def give_student(
    book: "Gradebook", assignment: str, student: str, kept: dict[str, dict[str, Any]]
) -> None:
    """Set the manual columns of a student's submission to those of :func:`of_student`."""
    for notebook in book.find_submission(assignment, student).notebooks:
        for name, rows in _by_cell(notebook).items():
            for row in rows:
                give(row, kept.get(notebook.name, {}).get(name, {}))
    book.db.commit()


def _by_cell(notebook):
    found: dict[str, list[Any]] = {}
    for row in (*notebook.grades, *notebook.comments):
        found.setdefault(row.name, []).append(row)
    return found
