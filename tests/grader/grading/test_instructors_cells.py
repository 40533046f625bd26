"""An instructor's own cells of every kind that nbgrader has, beside ours: each is graded by
nbgrader's own rules, by both routes.
"""

import nbformat
import pytest

from grader.grading import grade
from tests.grader.courses import forget, give, gradebook_rows, nbgrader, points, ran, read, submit
from tests.grader.instructors_cells import OWN, with_texts
from tests.grader.submissions import bare, without, work


def autograded(course):
    return nbformat.read(course.path / "autograded/dan/ch04/ch04.ipynb", 4).cells


def given(course, student="dan"):
    """{cell: (automatic points, needs a person)} of the instructor's cells."""
    names = {c["metadata"]["nbgrader"]["grade_id"] for c in OWN[1:7]}
    with course.gradebook() as book:
        grades = book.find_submission("ch04", student).notebooks[0].grades
        return {g.name: (g.auto_score, g.needs_manual_grade) for g in grades if g.name in names}


RIGHT = "def square(x):\n    return x * TWO * x / 2"  # uses the instructor's locked cell
WAITS, BLANK = (None, True), (0.0, False)
CASES = {
    "all right": (
        {"essay": "Because.", "sketch": "plot()", "square": RIGHT},
        {"essay": WAITS, "sketch": WAITS, "test_square": (4.0, False), "share": (0.5, False)},
    ),
    "seen tests pass, hidden ones do not": (
        {"square": "def square(x):\n    return abs(x) * x"},
        {"essay": BLANK, "sketch": BLANK, "test_square": (0.0, False), "share": (0.5, False)},
    ),
    "nothing": (
        {},
        {"essay": BLANK, "sketch": BLANK, "test_square": (0.0, False), "share": (0.0, False)},
    ),
}


@pytest.mark.parametrize("how", CASES)
def test_instructors_cells_are_graded_by_nbgraders_rules_in_both_routes(mixed, how):
    texts, expected = CASES[how]
    submit(mixed, "dan", with_texts(work(mixed, "dan"), **texts))
    (result,) = grade(mixed, "ch04", ["dan"])
    assert result.problem == ""
    expected = {**expected, "at_home": WAITS}
    assert given(mixed) == expected
    assert result.points == 11 + sum(p or 0 for p, _ in expected.values())
    assert result.waiting == sum(w for _, w in expected.values())
    assert result.out_of == 11 + 15
    ours = gradebook_rows(mixed), autograded(mixed)
    forget(mixed, "dan")
    ran(nbgrader("autograde", "ch04", cwd=mixed.path))
    theirs = gradebook_rows(mixed), autograded(mixed)
    assert ours == theirs


def test_a_students_text_is_kept_for_the_person_who_grades_it(mixed):
    texts = {"essay": "Because I <b>say</b> so.\n\n$x^2$", "sketch": "plot(1)"}
    submit(mixed, "dan", with_texts(work(mixed, "dan"), **texts))
    grade(mixed, "ch04", ["dan"])
    cells = read(mixed.path / "autograded/dan/ch04/ch04.ipynb")["cells"]
    kept = {c["id"]: c["source"] for c in cells}
    assert {n: kept[n] for n in texts} == texts
    assert "hidden words" in kept["test_square"]  # for whoever grades
    assert "2 for a photo" in kept["at_home"]


def test_feedback_holds_comments_and_no_hidden_test_or_mark_scheme(mixed):
    submit(mixed, "dan", with_texts(work(mixed, "dan"), essay="Because."))
    grade(mixed, "ch04", ["dan"])
    give(mixed, "dan", "essay", 2.5, None, "More words, please.")
    ran(nbgrader("generate_feedback", "ch04", cwd=mixed.path))
    page = (mixed.path / "feedback/dan/ch04/ch04.html").read_text()
    assert "More words, please." in page
    assert "Because." in page
    assert "2.5" in page
    for secret in ("hidden words", "HIDDEN", "2 for a photo", "MARK SCHEME"):
        assert secret not in page


def test_points_given_by_hand_and_extra_credit_stay_and_count(mixed):
    submit(mixed, "dan", with_texts(work(mixed, "dan"), essay="Because."))
    grade(mixed, "ch04", ["dan"])
    give(mixed, "dan", "essay", 2.0, 0.75, None)
    give(mixed, "dan", "at_home", 4.0, None, None)
    (result,) = grade(mixed, "ch04", ["dan"])
    assert (result.points, result.extra, result.waiting) == (11 + 2 + 4 + 0.75, 0.75, 0)
    # changed work: the person who gave points is asked to look again
    submit(mixed, "dan", with_texts(work(mixed, "dan"), essay="Because of something else."))
    (result,) = grade(mixed, "ch04", ["dan"])
    assert (result.points, result.waiting) == (11 + 2 + 4 + 0.75, 2)


def test_an_essay_whose_metadata_are_gone_waits_for_a_person_and_an_empty_one_does_not(mixed):
    done = with_texts(work(mixed, "dan"), essay="Because.", sketch="plot()", square=RIGHT)
    submit(mixed, "dan", {**done, "cells": bare(done["cells"])})
    (result,) = grade(mixed, "ch04", ["dan"])
    assert result.points == 11 + 4.5
    found = given(mixed)
    assert (found["essay"], found["sketch"]) == (WAITS, WAITS)
    assert "Because." in [c["source"] for c in autograded(mixed)]
    submit(mixed, "dan", without(work(mixed, "dan"), "essay", "sketch"))
    grade(mixed, "ch04", ["dan"])
    assert (given(mixed)["essay"], given(mixed)["sketch"]) == (BLANK, BLANK)


def test_what_a_test_says_never_reaches_the_student(mixed):
    """Student code that catches what the hidden test does has nowhere to write it."""
    spy = (
        "seen = []\nclass Spy(float):\n    def __eq__(self, other):\n        import sys\n"
        "        seen.append(sys._getframe(1).f_code.co_consts)\n        return False\n"
        "def square(x):\n    return Spy(x * x)"
    )
    notebook = with_texts(work(mixed, "dan", p4_31="raise ValueError(str(seen))"), square=spy)
    submit(mixed, "dan", notebook)
    grade(mixed, "ch04", ["dan"])
    output = [comment for _, _, comment in points(mixed)["dan"].values() if comment]
    assert not [text for text in output if "hidden words" in text or "49" in text]
