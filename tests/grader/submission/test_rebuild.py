"""Of a submission, only the texts of the answer cells count."""

import pytest

from grader.grading import grade
from tests.grader.courses import submit
from tests.grader.submissions import NOTEBOOKS


@pytest.mark.parametrize("how", NOTEBOOKS)
def test_a_notebook_that_was_changed_is_graded_by_its_answer_cells_alone(fresh, how):
    change, expected, number, words = NOTEBOOKS[how]
    submit(fresh, "dan", change(fresh))
    result = grade(fresh, "ch04", ["dan"], workers=1)[0]
    assert (result.problem, result.points) == ("", expected)
    if number:
        assert words in result.scores[number].note
