"""Only the texts of the answer cells of a submission count."""

import pytest

from grader.grading import grade
from grader.submission.recognition import places_by_name, places_of
from tests.grader.courses import released_sheet, submit
from tests.grader.submissions import NOTEBOOKS, without


@pytest.mark.parametrize("how", NOTEBOOKS)
def test_a_notebook_that_was_changed_is_graded_by_its_answer_cells_alone(fresh, how):
    change, expected, number, words = NOTEBOOKS[how]
    submit(fresh, "dan", change(fresh))
    result = grade(fresh, "ch04", ["dan"], workers=1)[0]
    assert (result.problem, result.points) == ("", expected)
    if number:
        assert words in result.scores[number].note


def assigning(text, fresh):
    """True if a code cell with this text, beside the receipt of 4/16, is taken for its answer."""
    master = released_sheet(fresh)
    cells = without(master, "answer-4-16")["cells"]
    at = next(n for n, c in enumerate(cells) if c["id"] == "receipt-4-16")
    cells.insert(at, {"cell_type": "code", "metadata": {}, "source": text})
    place = places_of(cells, master, places_by_name(master))[at]
    return place is not None and master["cells"][place]["id"] == "answer-4-16"


@pytest.mark.parametrize(("text", "is_one"), [
    ("v_D = 1", True), ("x = 2\n a, v_D= 1", True), ("x = v_D = 1", True), ("(v_D, x) = y", True),
    ("v_D == 1", False), ("v_D <= w == 1", True), ("my_v_D = 1", False), ("v_D\n= 1", False),
    ("x = v_D", False), ("f(v_D) == 3", False), pytest.param("v_D " * 10**6, False, id="long"),
])  # fmt: skip
def test_an_answer_without_its_marks_is_known_by_its_names(fresh, text, is_one):
    """At any length: a regular expression took quadratic time, weeks for a notebook of 64 MB."""
    assert assigning(text, fresh) == is_one
