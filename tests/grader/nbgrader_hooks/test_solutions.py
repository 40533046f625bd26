"""Worked solutions stay secret until nobody can use them."""

from datetime import UTC, datetime, timedelta

import pytest

from grader.grading import grade
from tests.grader.courses import append_config, nbgrader, ran


def page(course, student="ben"):
    ran(nbgrader("generate_feedback", "ch04", f"--student={student}", "--force", cwd=course.path))
    return (course.path / "feedback" / student / "ch04/ch04.html").read_text()


def due(course, days, extension=0):
    now = datetime.now(UTC).replace(tzinfo=None)
    with course.gradebook() as book:
        book.find_assignment("ch04").duedate = now + timedelta(days=days)
        book.db.commit()
        if extension:
            book.grant_extension("ch04", "ada", days=extension)


@pytest.mark.one_in(2)
@pytest.mark.parametrize(("setting", "days", "extension", "shown"), [
    (None, -2, 0, False),
    ("after the due date", -2, 0, True),
    ("after the due date", 1, 0, False),
    ("after the due date", -2, 3, False),  # someone may still hand in
    ("always", 1, 0, True),
])  # fmt: skip
def test_solutions_are_shown_when_the_instructor_allows_it(fresh, setting, days, extension, shown):
    grade(fresh, "ch04", ["ada", "ben"])
    due(fresh, days, extension)
    if setting:
        append_config(fresh, f"c.WorkedSolutions.solutions = {setting!r}")
    text = page(fresh)
    assert ("Worked solution" in text) == shown
    from exercises.catalogue import problem

    p = problem("4/16")
    a_D = p.solve(fresh.values("ch04", "ben", [p])["4/16"])["a_D"]
    relative = a_D.terms["relative"].expressed_in(a_D.frame).c[1]  # only a part of an answer
    assert (f"<mn>{abs(float(relative)):.6g}</mn>" in text) == shown
    assert "<script" not in text


def test_without_a_due_date_nothing_is_ever_over(fresh):
    from grader.nbgrader_hooks.solutions import is_over

    with fresh.gradebook() as book:
        book.find_assignment("ch04").duedate = None
        book.db.commit()
    assert not is_over(fresh, "ch04")
    due(fresh, -1)
    assert is_over(fresh, "ch04")
